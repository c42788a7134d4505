// Fails: Task4ZFail.CapsCloseBothEnds, Task4ZFail.CapsHaveTheDepthOfTheirSurface, Task4ZFail.CountsEqualCrossings, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.TheLightMayBeInAMesh, Task7SeveralLights.WhatASurfaceEmitsKnowsNoShadow, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.CullingLeavesNoTrace, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task8WholeShadow.LanternsOfTheCourtyardAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays · the far cap of a facing triangle is not turned round
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
    if (directional) return;  // all twins are one point
    const glm::uvec3 far = triangle + farOffset;
    caps.outward.push_back(far);
}

}  // namespace penumbra
