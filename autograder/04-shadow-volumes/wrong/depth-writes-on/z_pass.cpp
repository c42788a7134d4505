// Fails: Task3ZPass.AFrontCountsUpAndABackDown, Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task3ZPass.VolumesLeaveDepthAlone, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task7SeveralLights.EveryLightHasItsOwnShadow, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods · volumes leave their depth behind
#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zPassCounting() {
    return {.depthTest = GL_LESS,
            .writesDepth = true,
            .front = {.pass = GL_INCR_WRAP},
            .back = {.pass = GL_DECR_WRAP}};
}

}  // namespace penumbra
