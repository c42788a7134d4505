// Fails: Task3Drawing.DarknessComesOnceUnderOverlappingCasters, Task3Drawing.NothingIsDrawnOverCasters, Task3Drawing.StopsAtTheReceiversEdge · no marks: darkened once a layer, over casters and beside the receiver
#include "planar_shadow.h"

namespace penumbra {

DrawState receiverDrawing() { return {}; }

DrawState shadowDrawing() { return {.depthTest = false}; }

}  // namespace penumbra
