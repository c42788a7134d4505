// Fails: Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.MeshesThatNeedAllTheirTrianglesAreKnown, Task6OpenMeshes.TheLightMayBeInAMesh, Task6OpenMeshes.TheSunIsInNoMesh, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.OpenMeshesAgreeWithRays · facing triangles are taken to be enough for every mesh
#include "shadow_volumes.h"

namespace penumbra {

bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    (void)mesh, (void)edges, (void)light;
    return false;
}

std::vector<int> allTriangles(const Mesh& mesh, glm::vec4 light) {
    std::vector<int> weights;
    weights.reserve(mesh.triangles.size());
    for (const glm::uvec3 t : mesh.triangles) {
        const auto& p = mesh.positions;
        weights.push_back(orientation(p[t.x], p[t.y], p[t.z], light));
    }
    return weights;
}

}  // namespace penumbra
