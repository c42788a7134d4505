// How dragging moves camera and light. Angles in radians, drags in fractions of the picture's
// height.
//
//   orbit(camera, {0.02f, 0.01f});
//   orbitLight(light, camera, bounds(scene).center(), {0.02f, 0.0f});
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace penumbra {

// Around the target: x to the right, y up; never over the pole.
void orbit(Camera& camera, glm::vec2 angles);
// Camera and target move so that the point under the cursor follows it.
void pan(Camera& camera, glm::vec2 drag);
// Towards the target (steps > 0) or away, a tenth of the distance a step.
void dolly(Camera& camera, float steps);
// The far plane reaches past the scene wherever the camera went; never nearer than `least`.
void keepInRange(Camera& camera, const Box& box, float least);

// Around `pivot`, distance and aim kept: the light's frame turns with it.
void orbitLight(Light& light, const Camera& camera, glm::vec3 pivot, glm::vec2 angles);

}  // namespace penumbra
