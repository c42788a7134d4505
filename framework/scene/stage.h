// Puts a bare model on a ground, with a light whose shadow is long and a camera that shows both.
//
//   Scene scene = importObj("deer.obj");
//   stageModel(scene, {.size = 3.0f});
#pragma once

#include <vector>

#include "scene/scene.h"

namespace penumbra {

struct Stage {
    float size = 3.0f;         // of the model's largest side, world units
    float lift = 0.0f;         // of its lowest point over the ground
    float turnDegrees = 0.0f;  // about the vertical axis, counter-clockwise seen from above
};

// Scales, turns and moves the model to the origin, onto a ground of 12 x 12 (a little more where
// its shadow is longer); sets camera and light.
void stageModel(Scene& scene, const Stage& stage);

// Where points cast the shadow of `light` (its centre and corners) on y = 0.
std::vector<glm::vec3> shadowOnGround(const std::vector<glm::vec3>& blockers, const Light& light);

// A camera that looks along `forward` with all points in a square view, a tenth of it to spare.
Camera cameraShowing(const std::vector<glm::vec3>& points, glm::vec3 forward, float verticalFov);

std::vector<glm::vec3> corners(const Box& box);
std::vector<glm::vec3> vertices(const Scene& scene);

}  // namespace penumbra
