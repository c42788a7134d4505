// Fails: Task4ZFail.TheSunNeedsNoFarCap · a directional light gets a far cap, too
#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zFailCounting() {
    return {.depthTest = GL_LESS,
            .writesDepth = false,
            .front = {.depthFail = GL_DECR_WRAP},
            .back = {.depthFail = GL_INCR_WRAP}};
}

void appendCaps(glm::uvec3 triangle, int weight, std::uint32_t farOffset, bool directional,
                VolumeTriangles& caps) {
    (weight > 0 ? caps.outward : caps.inward).push_back(triangle);
    (void)directional;
    const glm::uvec3 far = triangle + farOffset;
    caps.outward.push_back(weight > 0 ? glm::uvec3(far.x, far.z, far.y) : far);
}

}  // namespace penumbra
