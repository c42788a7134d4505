// Fails: Task1Silhouette.SilhouettesOfClosedMeshesAreLoops, Task6OpenMeshes.TheSunIsInNoMesh · the direction to the sun is taken for a place
#include "shadow_volumes.h"

namespace penumbra {

bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    if (!closed(edges) || signedVolume(mesh) < 0) return true;
    return windingNumber(mesh, glm::vec3(light)) != 0;
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
