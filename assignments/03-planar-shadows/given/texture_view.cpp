#include "texture_view.h"

#include <algorithm>

namespace penumbra {

namespace {

constexpr float kWidestTangent = 6.0f;  // 80.5 degrees from the axis

struct Window {
    glm::vec2 lower{1e30f}, upper{-1e30f};
};

// Tangents for a point light, lengths for a directional one.
Window windowOf(const Scene& casters, const glm::mat4& viewFromWorld, bool directional) {
    Window window;
    const Window whole{glm::vec2(-kWidestTangent), glm::vec2(kWidestTangent)};
    for (const Mesh& mesh : casters.meshes)
        for (const glm::vec3 position : mesh.positions) {
            const glm::vec3 p = viewFromWorld * glm::vec4(position, 1.0f);
            if (!directional && p.z >= 0) return whole;  // beside or behind the light
            const glm::vec2 q = directional
                                    ? glm::vec2(p)
                                    : glm::clamp(glm::vec2(p) / -p.z, whole.lower, whole.upper);
            window.lower = glm::min(window.lower, q);
            window.upper = glm::max(window.upper, q);
        }
    return window.lower.x < window.upper.x && window.lower.y < window.upper.y ? window : whole;
}

}  // namespace

glm::mat4 shadowTextureView(const Scene& casters, const Light& light) {
    const Box box = bounds(casters);
    const glm::vec3 middle = box.empty() ? light.center + light.forward() : box.center();
    const glm::vec3 towards =
        light.directional || glm::length(middle - light.center) <= 1e-4f * box.diagonal()
            ? light.forward()
            : middle - light.center;
    const glm::vec3 eye = light.directional ? middle : light.center;
    const glm::mat4 viewFromWorld = Light::lookingAt(eye, eye + towards, 1.0f).viewFromWorld();

    const Window w = windowOf(casters, viewFromWorld, light.directional);
    const glm::vec2 scale = 2.0f / (w.upper - w.lower);
    const glm::vec2 shift = -(w.upper + w.lower) / (w.upper - w.lower);
    glm::mat4 clipFromView(0.0f);
    clipFromView[0][0] = scale.x, clipFromView[1][1] = scale.y;
    if (light.directional)
        clipFromView[3] = {shift, 0.0f, 1.0f};
    else
        clipFromView[2] = {-shift, 0.0f, -1.0f};
    return clipFromView * viewFromWorld;
}

}  // namespace penumbra
