#include "render/light_frustum.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>

#include "render/receivers.h"

namespace penumbra {

namespace {

constexpr float kWidestTangent = 6.0f;

struct Extent {
    float lower = kWidestTangent, upper = -kWidestTangent;

    void include(float tangent) {
        tangent = std::clamp(tangent, -kWidestTangent, kWidestTangent);
        lower = std::min(lower, tangent);
        upper = std::max(upper, tangent);
    }
    float middle() const { return 0.5f * (lower + upper); }
    float width() const { return upper - lower; }
    // As far as both the margin and what is there to be seen reach.
    Extent widened(float margin, const Extent& blockers) const {
        return {std::min(lower, std::max(lower - margin, blockers.lower)),
                std::max(upper, std::min(upper + margin, blockers.upper))};
    }
};

// Of points before the light, in its view space.
struct Seen {
    Extent x, y;
    float nearest = 1e30f, farthest = 0;

    void include(glm::vec3 p) {
        x.include(p.x / -p.z);
        y.include(p.y / -p.z);
        nearest = std::min(nearest, -p.z);
        farthest = std::max(farthest, -p.z);
    }
};

// A light point moved by `halfWidth` moves what stands at `distance` by so much before a receiver
// at `farthest`.
float parallax(float halfWidth, float distance, float farthest) {
    return halfWidth * (1 / distance - 1 / farthest);
}

// Planes around the hull of the light's square and the receivers, in world space: at distance z the
// receivers' window, widened by the parallax of half the light.
//
//     x >= z lower - half (1 - z / farthest),   x <= z upper + half (1 - z / farthest)
std::vector<glm::vec4> blockerRegion(const Seen& receivers, float half,
                                     const glm::mat4& viewFromWorld, glm::vec4 beforeLight) {
    const float narrowing = half / receivers.farthest;
    const auto world = [&](glm::vec4 plane) { return glm::transpose(viewFromWorld) * plane; };
    const Extent &x = receivers.x, &y = receivers.y;  // z = -1 times the third coordinate
    return {world({1, 0, x.lower + narrowing, half}), world({-1, 0, -x.upper + narrowing, half}),
            world({0, 1, y.lower + narrowing, half}), world({0, -1, -y.upper + narrowing, half}),
            world({0, 0, 1, receivers.farthest}),     beforeLight};
}

}  // namespace

glm::mat4 LightFrustum::clipFromView() const {
    const float n = nearPlane;
    return glm::frustum(left * n, right * n, bottom * n, top * n, n, farPlane);
}

glm::vec2 LightFrustum::widthScaleUv(float lightWidth) const {
    return lightWidth * (1 / nearPlane - 1 / farPlane) / tangents();
}

LightFrustum areaLightFrustum(const View& view) {
    const Light& light = view.light;
    const glm::mat4 viewFromWorld = light.viewFromWorld();
    const glm::mat4 cameraClip = view.camera.clipFromView(float(view.size.x) / float(view.size.y)) *
                                 view.camera.viewFromWorld();
    // Surfaces that cross the light's plane count from just before it.
    const float start = 1e-4f * bounds(view.scene).diagonal();
    const glm::vec3 forward = light.forward();
    const glm::vec4 before(forward, -glm::dot(forward, light.center) - start);

    Seen receivers;
    for (const glm::vec3 world : visiblePoints(view.scene, cameraClip, Clip::all, before))
        if (const glm::vec3 p = viewFromWorld * glm::vec4(world, 1.0f); p.z < 0)
            receivers.include(p);
    if (receivers.farthest == 0) return {};  // nothing is lit

    const float half = 0.5f * light.width;
    Seen blockers;
    for (const glm::vec3 world :
         pointsInside(view.scene, blockerRegion(receivers, half, viewFromWorld, before)))
        if (const glm::vec3 p = viewFromWorld * glm::vec4(world, 1.0f); p.z < 0)
            blockers.include(p);
    const float nearest = std::min(receivers.nearest, blockers.nearest);
    const float farPlane = 1.001f * receivers.farthest;
    const float margin = parallax(half, nearest, receivers.farthest);
    const Extent x = receivers.x.widened(margin, blockers.x);
    const Extent y = receivers.y.widened(margin, blockers.y);
    // A lone point or a line still needs a window.
    const float least = 1e-6f;
    return {x.lower - least,
            x.upper + least,
            y.lower - least,
            y.upper + least,
            std::max(0.999f * nearest, 1e-4f * farPlane),
            farPlane};
}

}  // namespace penumbra
