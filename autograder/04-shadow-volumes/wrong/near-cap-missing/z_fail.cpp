// Fails: Task4ZFail.AVolumeMayCutTheNearPlane, Task4ZFail.CapsCloseBothEnds, Task4ZFail.CapsHaveTheDepthOfTheirSurface, Task4ZFail.CountsEqualCrossings, Task4ZFail.HundredsOfLayersWrapAround, Task4ZFail.TheEyeMayStandInAVolume, Task4ZFail.TheSunNeedsNoFarCap, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.TheLightMayBeInAMesh, Task6OpenMeshes.VolumesOfSingleTrianglesCountAlike, Task7SeveralLights.EveryLightHasItsOwnShadow, Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task8WholeShadow.AFloatCountsBeyond255, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.CullingLeavesNoTrace, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task8WholeShadow.LanternsOfTheCourtyardAgreeWithRays, Task8WholeShadow.OpenMeshesAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays · volumes are open at their near end
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
    if (directional) return;  // all twins are one point
    const glm::uvec3 far = triangle + farOffset;
    caps.outward.push_back(weight > 0 ? glm::uvec3(far.x, far.z, far.y) : far);
}

}  // namespace penumbra
