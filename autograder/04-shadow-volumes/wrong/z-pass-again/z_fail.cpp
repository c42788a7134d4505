// Fails: Task4ZFail.AVolumeMayCutTheNearPlane, Task4ZFail.BehindTheSurfaceABackCountsUpAndAFrontDown, Task4ZFail.TheEyeMayStandInAVolume, Task6OpenMeshes.TheLightMayBeInAMesh, Task7SeveralLights.WhatASurfaceEmitsKnowsNoShadow, Task8WholeShadow.CullingLeavesNoTrace · what lies before the surface counts
#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zFailCounting() {
    return {.depthTest = GL_LESS,
            .writesDepth = false,
            .front = {.pass = GL_INCR_WRAP},
            .back = {.pass = GL_DECR_WRAP}};
}

void appendCaps(glm::uvec3 triangle, int weight, std::uint32_t farOffset, bool directional,
                VolumeTriangles& caps) {
    (weight > 0 ? caps.outward : caps.inward).push_back(triangle);
    if (directional) return;  // all twins are one point
    const glm::uvec3 far = triangle + farOffset;
    caps.outward.push_back(weight > 0 ? glm::uvec3(far.x, far.z, far.y) : far);
}

}  // namespace penumbra
