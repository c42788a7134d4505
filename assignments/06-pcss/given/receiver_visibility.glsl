#include "receiver.glsl"

float receiverVisibility(ivec2 pixel) { return softVisibility(receiverAt(pixel)); }
