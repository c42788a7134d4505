// Fails: Task1LightFrustum.LeavesOutWhatIsBehindTheLight, Task1LightFrustum.TouchesItsReceiversOnAllFourSides · the light's window is symmetric about its axis: wider than the receivers need
#include <algorithm>
#include <cmath>

#include "shadow_map.h"

namespace penumbra {

LightWindow fitLightWindow(std::span<const glm::vec3> receivers) {
    constexpr float kWidest = 6.0f;
    float widestX = 0.0f, widestY = 0.0f;
    bool any = false;
    for (const glm::vec3 p : receivers) {
        if (p.z >= 0.0f) continue;
        any = true;
        widestX = std::max(widestX, std::min(std::abs(p.x / p.z), kWidest));
        widestY = std::max(widestY, std::min(std::abs(p.y / p.z), kWidest));
    }
    return any ? LightWindow{-widestX, widestX, -widestY, widestY} : LightWindow{};
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
