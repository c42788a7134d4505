// Fails: Task1Silhouette.AnEdgeMayHaveOneTriangleOrThree, Task1Silhouette.EdgesSumTheirTrianglesByDirection, Task1Silhouette.SilhouettesOfClosedMeshesAreLoops, Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task4ZFail.AVolumeMayCutTheNearPlane, Task4ZFail.CapsHaveTheDepthOfTheirSurface, Task4ZFail.CountsEqualCrossings, Task4ZFail.HundredsOfLayersWrapAround, Task4ZFail.TheEyeMayStandInAVolume, Task4ZFail.TheSunNeedsNoFarCap, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.TheLightMayBeInAMesh, Task7SeveralLights.EveryLightHasItsOwnShadow, Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task7SeveralLights.WhatASurfaceEmitsKnowsNoShadow, Task8WholeShadow.AFloatCountsBeyond255, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.CullingLeavesNoTrace, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task8WholeShadow.LanternsOfTheCourtyardAgreeWithRays, Task8WholeShadow.OpenMeshesAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays · edge sums without the direction
#include "shadow_volumes.h"

namespace penumbra {

std::vector<int> facingTriangles(const Mesh& mesh, glm::vec4 light) {
    std::vector<int> facing;
    facing.reserve(mesh.triangles.size());
    for (const glm::uvec3 t : mesh.triangles) {
        const auto& p = mesh.positions;
        facing.push_back(orientation(p[t.x], p[t.y], p[t.z], light) > 0 ? 1 : 0);
    }
    return facing;
}

std::vector<int> edgeSums(const MeshEdges& edges, std::span<const int> weights) {
    std::vector<int> sums;
    sums.reserve(edges.edges.size());
    for (const MeshEdge& edge : edges.edges) {
        int sum = 0;
        for (const EdgeSide side : edges.sidesOf(edge)) sum += weights[side.triangle];
        sums.push_back(sum);
    }
    return sums;
}

}  // namespace penumbra
