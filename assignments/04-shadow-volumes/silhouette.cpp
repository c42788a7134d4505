#include "shadow_volumes.h"

namespace penumbra {

// Task 1a · which triangles face the light.                                            README §1
//   light   Light::position(): w = 1 a point, w = 0 a direction to the light
// Returns one number for each of mesh.triangles, in order: 1 if the light sees the triangle's
// corners counter-clockwise, else 0. A light in the triangle's plane does not see it, nor one
// without area. Ask orientation() (scene/orientation.h), whose sign is exact: a cross product in
// float gives two neighbours in one plane different answers.
std::vector<int> facingTriangles(const Mesh& mesh, glm::vec4 light) {
    (void)light;
    return std::vector<int>(mesh.triangles.size(), 0);  // yours
}

// Task 1b · how often the volume has a side at each edge, and which way.                README §1
//   weights   one for each triangle: 1, 0, and in Task 6 also -1
// Returns one number for each of edges.edges, in order: the sum of its triangles' weights, each
// times the direction in which that triangle runs along the edge (EdgeSide::direction). 0: no
// silhouette.
std::vector<int> edgeSums(const MeshEdges& edges, std::span<const int> weights) {
    (void)weights;
    return std::vector<int>(edges.edges.size(), 0);  // yours
}

}  // namespace penumbra
