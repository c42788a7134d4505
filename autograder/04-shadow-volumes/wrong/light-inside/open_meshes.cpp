// Fails: Task6OpenMeshes.MeshesThatNeedAllTheirTrianglesAreKnown, Task6OpenMeshes.TheLightMayBeInAMesh · a light in a closed mesh is taken to be outside
#include "shadow_volumes.h"

namespace penumbra {

bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    (void)light;
    return !closed(edges) || signedVolume(mesh) < 0;
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
