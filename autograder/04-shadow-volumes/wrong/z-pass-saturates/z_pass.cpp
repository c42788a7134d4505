// Fails: Task3ZPass.AFrontCountsUpAndABackDown, Task3ZPass.CountsEqualCrossings, Task3ZPass.HundredsOfLayersWrapAround, Task6OpenMeshes.CountsOfOpenMeshesEqualCrossings, Task7SeveralLights.EveryLightHasItsOwnShadow, Task8WholeShadow.BothMethodsCountAlike, Task8WholeShadow.FoliageAgreesWithRaysWithBothMethods · counts stay at 0 and at 255
#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zPassCounting() {
    return {.depthTest = GL_LESS,
            .writesDepth = false,
            .front = {.pass = GL_INCR},
            .back = {.pass = GL_DECR}};
}

}  // namespace penumbra
