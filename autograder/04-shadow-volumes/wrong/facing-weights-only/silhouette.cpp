// Fails: Task1Silhouette.AnEdgeMayHaveOneTriangleOrThree, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.OpenMeshesAgreeWithRays · averted triangles are left out of the sums
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
        for (const EdgeSide side : edges.sidesOf(edge))
            sum += side.direction * (weights[side.triangle] > 0 ? 1 : 0);
        sums.push_back(sum);
    }
    return sums;
}

}  // namespace penumbra
