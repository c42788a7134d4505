// Fails: Task3Drawing.NothingIsDrawnOverCasters, Task3Drawing.StopsAtTheReceiversEdge · each pixel is darkened once, whether it shows the receiver or not
#include "planar_shadow.h"

namespace penumbra {

DrawState receiverDrawing() { return {}; }

DrawState shadowDrawing() {
    return {.stencilFunction = GL_EQUAL, .passes = GL_INCR, .depthTest = false};
}

}  // namespace penumbra
