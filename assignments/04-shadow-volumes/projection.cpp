#include <glm/ext/matrix_clip_space.hpp>

#include "shadow_volumes.h"

namespace penumbra {

// Task 4c · a perspective projection whose far plane is at infinity.                    README §4
//   verticalFov   [radians]      aspect   width / height      nearPlane   > 0 [world]
// Returns clipFromView for a camera that looks along -z: window depth 0 on the near plane, and z =
// w, depth 1, for every point at infinity. glm's matrices are [column][row].
glm::mat4 infiniteProjection(float verticalFov, float aspect, float nearPlane) {
    return glm::perspective(verticalFov, aspect, nearPlane, 1000.0f * nearPlane);  // yours
}

}  // namespace penumbra
