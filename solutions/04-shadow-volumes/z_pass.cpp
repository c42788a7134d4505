#include "shadow_volumes.h"

namespace penumbra {

StencilCounting zPassCounting() {
    return {.depthTest = GL_LESS,
            .writesDepth = false,
            .front = {.pass = GL_INCR_WRAP},
            .back = {.pass = GL_DECR_WRAP}};
}

}  // namespace penumbra
