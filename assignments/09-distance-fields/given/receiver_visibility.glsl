#include "receiver.glsl"

float receiverVisibility(ivec2 pixel) {
    Receiver receiver = receiverAt(pixel);
    return min(softVisibility(receiver), lightAboveHorizon(receiver));
}
