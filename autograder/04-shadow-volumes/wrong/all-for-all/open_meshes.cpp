// Fails: Task1Silhouette.SilhouettesOfClosedMeshesAreLoops, Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task4ZFail.AVolumeMayCutTheNearPlane, Task4ZFail.CapsHaveTheDepthOfTheirSurface, Task4ZFail.CountsEqualCrossings, Task4ZFail.HundredsOfLayersWrapAround, Task4ZFail.TheEyeMayStandInAVolume, Task4ZFail.TheSunNeedsNoFarCap, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.MeshesThatNeedAllTheirTrianglesAreKnown, Task6OpenMeshes.TheLightMayBeInAMesh, Task6OpenMeshes.TheSunIsInNoMesh, Task8WholeShadow.AFloatCountsBeyond255 · every mesh gets all its triangles
#include "shadow_volumes.h"

namespace penumbra {

bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    (void)mesh, (void)edges, (void)light;
    return true;
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
