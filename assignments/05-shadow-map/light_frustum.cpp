#include <algorithm>

#include "shadow_map.h"

namespace penumbra {

// Task 1a · the light's view, as narrow as the receivers allow.                        README §1
//   receivers   corners of all that the camera sees, in light view space; may be empty  [world]
// Returns tangents x/-z and y/-z: every receiver in front of the light (z < 0) lies within, and
// none of the four sides could move in. Points with z >= 0 are behind the light and count for
// nothing. Close to z = 0 tangents grow without bound: clamp each to [-6, 6]. With no
// receiver in front: the default LightWindow{}.
LightWindow fitLightWindow(std::span<const glm::vec3> receivers) {
    (void)receivers;
    return {-6.0f, 6.0f, -6.0f, 6.0f};  // yours
}

// Task 1b · near and far plane, as close together as receivers and blockers allow.       README §1
//   receivers   as above
//   blockers    corners of all surfaces inside the window, in light view space           [world]
// Returns distances along the light's axis: no point of either list with z < 0 is nearer than
// nearPlane, no receiver is farther than farPlane, with 0.1 % of room on both sides (rounding must
// not clip a surface that lies on a plane). nearPlane >= farPlane / 10⁵. With no receiver in front:
// the default DepthRange{}.
DepthRange fitDepthRange(std::span<const glm::vec3> receivers,
                         std::span<const glm::vec3> blockers) {
    (void)receivers, (void)blockers;
    return {0.01f, 1000.0f};  // yours
}

}  // namespace penumbra
