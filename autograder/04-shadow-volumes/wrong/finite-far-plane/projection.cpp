// Fails: Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task4ZFail.AVolumeMayCutTheNearPlane, Task4ZFail.CapsHaveTheDepthOfTheirSurface, Task4ZFail.CountsEqualCrossings, Task4ZFail.HundredsOfLayersWrapAround, Task4ZFail.PointsAtInfinityLieInTheClipVolume, Task4ZFail.TheProjectionHasNoFarPlane, Task4ZFail.TheSunNeedsNoFarCap, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.TheLightMayBeInAMesh, Task6OpenMeshes.VolumesOfSingleTrianglesCountAlike, Task7SeveralLights.EveryLightHasItsOwnShadow, Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task7SeveralLights.WhatASurfaceEmitsKnowsNoShadow, Task8WholeShadow.AFloatCountsBeyond255, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.CullingLeavesNoTrace, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task8WholeShadow.LanternsOfTheCourtyardAgreeWithRays, Task8WholeShadow.OpenMeshesAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays · the projection has a far plane
#include <cmath>

#include "shadow_volumes.h"

namespace penumbra {

glm::mat4 infiniteProjection(float verticalFov, float aspect, float nearPlane) {
    const float scale = 1.0f / std::tan(0.5f * verticalFov);
    glm::mat4 clipFromView(0.0f);  // [column][row]
    clipFromView[0][0] = scale / aspect;
    clipFromView[1][1] = scale;
    clipFromView[2][2] = -(12.0f + nearPlane) / (12.0f - nearPlane);
    clipFromView[2][3] = -1.0f;
    clipFromView[3][2] = -24.0f * nearPlane / (12.0f - nearPlane);
    return clipFromView;
}

}  // namespace penumbra
