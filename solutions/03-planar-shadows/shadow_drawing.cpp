#include "planar_shadow.h"

namespace penumbra {

DrawState receiverDrawing() { return {.stencilReference = 1, .passes = GL_REPLACE}; }

DrawState shadowDrawing() {
    return {
        .stencilFunction = GL_EQUAL, .stencilReference = 1, .passes = GL_ZERO, .depthTest = false};
}

}  // namespace penumbra
