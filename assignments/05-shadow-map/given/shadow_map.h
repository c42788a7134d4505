// What given code calls of yours in C++. Light view space: the light's centre is the origin, x
// right, y up, the light looks along -z, so that a point's distance along the light's axis is -z.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace penumbra {

// The sides of the light's view as tangents: x / -z and y / -z. left < right, bottom < top.
struct LightWindow {
    float left = -1.0f, right = 1.0f, bottom = -1.0f, top = 1.0f;
};

// Distances along the light's axis, 0 < nearPlane < farPlane [world].
struct DepthRange {
    float nearPlane = 0.1f, farPlane = 100.0f;
};

// light_frustum.cpp
LightWindow fitLightWindow(std::span<const glm::vec3> receivers);
DepthRange fitDepthRange(std::span<const glm::vec3> receivers, std::span<const glm::vec3> blockers);

}  // namespace penumbra
