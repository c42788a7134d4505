#include "receiver.glsl"

float receiverVisibility(ivec2 pixel) { return filteredVisibility(receiverAt(pixel)); }
