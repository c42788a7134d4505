// Fails: Task3ZPass.AFrontCountsUpAndABackDown, Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task7SeveralLights.EveryLightHasItsOwnShadow, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods · volumes are drawn without a depth test
#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zPassCounting() {
    return {.depthTest = GL_ALWAYS,
            .writesDepth = false,
            .front = {.pass = GL_INCR_WRAP},
            .back = {.pass = GL_DECR_WRAP}};
}

}  // namespace penumbra
