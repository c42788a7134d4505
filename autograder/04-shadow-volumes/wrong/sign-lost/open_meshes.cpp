// Fails: Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.EveryTriangleCountsOnceTurnedToTheLight, Task6OpenMeshes.TheLightMayBeInAMesh, Task6OpenMeshes.VolumesOfSingleTrianglesCountAlike, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods · averted triangles are not turned
#include "shadow_volumes.h"

namespace penumbra {

bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    if (!closed(edges) || signedVolume(mesh) < 0) return true;
    return light.w != 0 && windingNumber(mesh, glm::vec3(light)) != 0;
}

std::vector<int> allTriangles(const Mesh& mesh, glm::vec4 light) {
    std::vector<int> weights;
    weights.reserve(mesh.triangles.size());
    for (const glm::uvec3 t : mesh.triangles) {
        const auto& p = mesh.positions;
        weights.push_back(orientation(p[t.x], p[t.y], p[t.z], light) != 0 ? 1 : 0);
    }
    return weights;
}

}  // namespace penumbra
