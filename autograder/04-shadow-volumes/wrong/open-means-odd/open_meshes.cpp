// Fails: Task6OpenMeshes.MeshesThatNeedAllTheirTrianglesAreKnown, Task6OpenMeshes.TheSunIsInNoMesh · a mesh counts as closed if an even number of triangles meet at each edge
#include "shadow_volumes.h"

namespace penumbra {

static bool evenEverywhere(const MeshEdges& edges) {
    for (const MeshEdge& edge : edges.edges)
        if (edge.sideCount % 2 != 0) return false;
    return true;
}

bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    if (!evenEverywhere(edges) || signedVolume(mesh) < 0) return true;
    return light.w != 0 && windingNumber(mesh, glm::vec3(light)) != 0;
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
