// Fails: Task3Drawing.NothingIsDrawnOverCasters · the receiver is marked where a caster hides it, too
#include "planar_shadow.h"

namespace penumbra {

DrawState receiverDrawing() {
    return {.stencilReference = 1, .depthFails = GL_REPLACE, .passes = GL_REPLACE};
}

DrawState shadowDrawing() {
    return {
        .stencilFunction = GL_EQUAL, .stencilReference = 1, .passes = GL_ZERO, .depthTest = false};
}

}  // namespace penumbra
