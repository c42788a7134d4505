#include "shadow_volumes.h"

namespace penumbra {

LightPass addLight() {
    return {.clearsStencil = true,
            .depthTest = GL_EQUAL,
            .writesDepth = false,
            .stencilTest = GL_EQUAL,
            .stencilReference = 0,
            .source = GL_ONE,
            .destination = GL_ONE};
}

}  // namespace penumbra
