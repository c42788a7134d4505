// Fails: Task4ZFail.CapsCloseBothEnds, Task6OpenMeshes.BrokenSolidsShadeLikeTheirTriangles, Task6OpenMeshes.CountsOfLeavesEqualCrossings, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task6OpenMeshes.VolumesOfSingleTrianglesCountAlike, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods, Task8WholeShadow.OpenMeshesAgreeWithRays · near caps of averted triangles count like the others
#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zFailCounting() {
    return {.depthTest = GL_LESS,
            .writesDepth = false,
            .front = {.depthFail = GL_DECR_WRAP},
            .back = {.depthFail = GL_INCR_WRAP}};
}

void appendCaps(glm::uvec3 triangle, int weight, std::uint32_t farOffset, bool directional,
                VolumeTriangles& caps) {
    caps.outward.push_back(triangle);
    if (directional) return;  // all twins are one point
    const glm::uvec3 far = triangle + farOffset;
    caps.outward.push_back(weight > 0 ? glm::uvec3(far.x, far.z, far.y) : far);
}

}  // namespace penumbra
