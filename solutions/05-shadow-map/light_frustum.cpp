#include <algorithm>

#include "shadow_map.h"

namespace penumbra {

LightWindow fitLightWindow(std::span<const glm::vec3> receivers) {
    constexpr float kWidest = 6.0f;
    LightWindow window{kWidest, -kWidest, kWidest, -kWidest};
    bool any = false;
    for (const glm::vec3 p : receivers) {
        if (p.z >= 0.0f) continue;
        any = true;
        const float x = std::clamp(p.x / -p.z, -kWidest, kWidest);
        const float y = std::clamp(p.y / -p.z, -kWidest, kWidest);
        window.left = std::min(window.left, x);
        window.right = std::max(window.right, x);
        window.bottom = std::min(window.bottom, y);
        window.top = std::max(window.top, y);
    }
    return any ? window : LightWindow{};
}

DepthRange fitDepthRange(std::span<const glm::vec3> receivers,
                         std::span<const glm::vec3> blockers) {
    float nearest = 1e30f, farthest = 0.0f;
    for (const glm::vec3 p : receivers)
        if (p.z < 0.0f) {
            nearest = std::min(nearest, -p.z);
            farthest = std::max(farthest, -p.z);
        }
    if (farthest == 0.0f) return {};
    for (const glm::vec3 p : blockers)
        if (p.z < 0.0f) nearest = std::min(nearest, -p.z);
    const float farPlane = 1.001f * farthest;
    return {std::max(0.999f * nearest, 1e-5f * farPlane), farPlane};
}

}  // namespace penumbra
