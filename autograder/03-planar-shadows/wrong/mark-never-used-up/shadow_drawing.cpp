// Fails: Task3Drawing.DarknessComesOnceUnderOverlappingCasters · the mark stays: the second layer darkens again
#include "planar_shadow.h"

namespace penumbra {

DrawState receiverDrawing() { return {.stencilReference = 1, .passes = GL_REPLACE}; }

DrawState shadowDrawing() {
    return {.stencilFunction = GL_EQUAL, .stencilReference = 1, .depthTest = false};
}

}  // namespace penumbra
