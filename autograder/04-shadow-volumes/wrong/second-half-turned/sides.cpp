// Fails: Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task4ZFail.AVolumeMayCutTheNearPlane, Task4ZFail.CapsHaveTheDepthOfTheirSurface, Task4ZFail.CountsEqualCrossings, Task4ZFail.HundredsOfLayersWrapAround, Task4ZFail.TheEyeMayStandInAVolume, Task5Sides.AnEdgeThatCountsTwiceHasTwoSides, Task5Sides.SidesOfClosedMeshesFaceOut, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.TheLightMayBeInAMesh, Task6OpenMeshes.VolumesOfSingleTrianglesCountAlike, Task7SeveralLights.EveryLightHasItsOwnShadow, Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task7SeveralLights.WhatASurfaceEmitsKnowsNoShadow, Task8WholeShadow.AFloatCountsBeyond255, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.CullingLeavesNoTrace, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task8WholeShadow.LanternsOfTheCourtyardAgreeWithRays, Task8WholeShadow.OpenMeshesAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays · the two triangles of a side face opposite ways
#include "shadow_volumes.h"

namespace penumbra {

void appendSide(std::uint32_t from, std::uint32_t to, std::uint32_t farOffset, bool directional,
                std::vector<glm::uvec3>& sides) {
    sides.push_back({to, from, from + farOffset});
    if (!directional) sides.push_back({to, to + farOffset, from + farOffset});
}

}  // namespace penumbra
