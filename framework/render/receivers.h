// What a shadow map must cover: the surfaces that the camera sees, and what can stand between them
// and the light.
//
//   std::vector<vec3> receivers = visiblePoints(scene, clipFromWorld);
//   std::vector<vec3> blockers = visiblePoints(scene, lightConeFromWorld, Clip::withoutDepth);
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

enum class Clip {
    all,           // the six planes of the clip volume
    withoutDepth,  // the four sides only, in front of the eye (w > 0): near and far are still to be
                   // found
};

// Corners, in world space, of every triangle's part inside the clip volume of `clipFromWorld`; the
// corners of the bounding box instead for a mesh that lies inside as a whole. Any convex region
// that holds these points holds all that is visible.
//
// `halfSpace`: a plane (n, -n·p) whose positive side alone counts; (0, 0, 0, 1) leaves nothing out.
std::vector<glm::vec3> visiblePoints(const Scene& scene, const glm::mat4& clipFromWorld,
                                     Clip clip = Clip::all,
                                     glm::vec4 halfSpace = {0.0f, 0.0f, 0.0f, 1.0f});

// The same for the convex region where n·p + d >= 0 for each of `planes` (n, d).
std::vector<glm::vec3> pointsInside(const Scene& scene, std::span<const glm::vec4> planes);

}  // namespace penumbra
