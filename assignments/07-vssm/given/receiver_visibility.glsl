// The receiver in this pixel, as your functions take it.
#include "receivers.glsl"
#include "variance_shadow.glsl"

Receiver receiverAt(ivec2 pixel) {
    Receiver receiver;
    receiver.uvDepth = texelFetch(receiverPosition, pixel, 0).xyz;
    receiver.lightHeight = texelFetch(receiverLightHeight, pixel, 0).xyz;
    receiver.slope = receiver.lightHeight.yz / (map.widthScaleUv * receiver.lightHeight.x);
    receiver.bias = constantBias(receiver.uvDepth.z);
    return receiver;
}

float receiverVisibility(ivec2 pixel) { return softVisibility(receiverAt(pixel)); }
