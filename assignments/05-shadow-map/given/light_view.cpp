#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>

#include "light_view.h"
#include "render/receivers.h"

namespace penumbra {

namespace {

// 80.5 degrees: past it a planar map spends its texels on nothing.
constexpr float kWidestTangent = 6.0f;

// The light's view before anything is fitted: the whole scene's bounding box, from a hundredth of
// its reach.
LightFrustum wholeScene(const Scene& scene, const glm::mat4& viewFromWorld) {
    const Box box = bounds(scene);
    LightFrustum whole{.window = {1e30f, -1e30f, 1e30f, -1e30f}, .depth = {}};
    float reach = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                               i & 4 ? box.upper.z : box.lower.z);
        const glm::vec3 p = viewFromWorld * glm::vec4(corner, 1.0f);
        reach = std::max(reach, glm::length(p));
        // A corner beside or behind the light: as wide as the map goes.
        const auto tangent = [&](float side) {
            return std::clamp(p.z < 0 ? side / -p.z : std::copysign(kWidestTangent, side),
                              -kWidestTangent, kWidestTangent);
        };
        whole.window.left = std::min(whole.window.left, tangent(p.x));
        whole.window.right = std::max(whole.window.right, tangent(p.x));
        whole.window.bottom = std::min(whole.window.bottom, tangent(p.y));
        whole.window.top = std::max(whole.window.top, tangent(p.y));
    }
    whole.depth = {0.01f * reach, 1.01f * reach};
    return whole;
}

// A student's frustum may be anything: what no projection can be made of is replaced by the whole
// scene's.
bool usable(const LightWindow& w) {
    return std::isfinite(w.left + w.right + w.bottom + w.top) && w.left < w.right &&
           w.bottom < w.top;
}
bool usable(const DepthRange& d) {
    return std::isfinite(d.farPlane) && 0 < d.nearPlane && d.nearPlane < d.farPlane;
}

std::vector<glm::vec3> transformed(std::vector<glm::vec3> points, const glm::mat4& matrix) {
    for (glm::vec3& p : points) p = matrix * glm::vec4(p, 1.0f);
    return points;
}

// In light view space. A surface that crosses the light's plane has corners on both sides: its part
// in front is added, so that the points before the light hold all of it.
std::vector<glm::vec3> visibleReceivers(const View& view, const glm::mat4& cameraClip) {
    auto points = visiblePoints(view.scene, cameraClip);
    const glm::vec3 forward = view.light.forward();
    const auto inFront = [&](glm::vec3 p) {
        return glm::dot(p - view.light.center, forward) > 0.0f;
    };
    if (!std::all_of(points.begin(), points.end(), inFront)) {
        const glm::vec3 start = view.light.center + 1e-4f * bounds(view.scene).diagonal() * forward;
        const auto front = visiblePoints(view.scene, cameraClip, Clip::all,
                                         glm::vec4(forward, -glm::dot(forward, start)));
        points.insert(points.end(), front.begin(), front.end());
    }
    return transformed(std::move(points), view.light.viewFromWorld());
}

}  // namespace

glm::mat4 clipFromView(const LightFrustum& frustum) {
    const LightWindow& w = frustum.window;
    const float n = frustum.depth.nearPlane;
    return glm::frustum(w.left * n, w.right * n, w.bottom * n, w.top * n, n,
                        frustum.depth.farPlane);
}

LightFrustum lightFrustum(const View& view) {
    const glm::mat4 viewFromWorld = view.light.viewFromWorld();
    LightFrustum frustum = wholeScene(view.scene, viewFromWorld);
    const bool fitWindow = view.settings.on("fit_window"), fitDepth = view.settings.on("fit_depth");
    if (!fitWindow && !fitDepth) return frustum;

    const glm::mat4 cameraClip = view.camera.clipFromView(float(view.size.x) / float(view.size.y)) *
                                 view.camera.viewFromWorld();
    const auto receivers = visibleReceivers(view, cameraClip);
    if (fitWindow)
        if (const LightWindow window = fitLightWindow(receivers); usable(window))
            frustum.window = window;
    if (fitDepth) {
        const auto blockers = transformed(
            visiblePoints(view.scene, clipFromView(frustum) * viewFromWorld, Clip::withoutDepth),
            viewFromWorld);
        if (const DepthRange depth = fitDepthRange(receivers, blockers); usable(depth))
            frustum.depth = depth;
    }
    return frustum;
}

}  // namespace penumbra
