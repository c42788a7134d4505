// Fails: Task7SeveralLights.ALightIsAddedWhereItsCountIsZero, Task7SeveralLights.EveryLightHasItsOwnShadow, Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task7SeveralLights.PicturesOfSingleLightsAddUp, Task8WholeShadow.CullingLeavesNoTrace · a light replaces the picture
#include "shadow_volumes.h"

namespace penumbra {

LightPass addLight() {
    return {.clearsStencil = true,
            .depthTest = GL_EQUAL,
            .writesDepth = false,
            .stencilTest = GL_EQUAL,
            .stencilReference = 0,
            .source = GL_ONE,
            .destination = GL_ZERO};
}

}  // namespace penumbra
