// The receiver in this pixel, as your functions take it.
#include "receivers.glsl"
#include "soft_shadow.glsl"
#include "receiver_plane.glsl"

Receiver receiverAt(ivec2 pixel) {
    Receiver receiver;
    receiver.uvDepth = texelFetch(receiverPosition, pixel, 0).xyz;
    receiver.lightHeight = texelFetch(receiverLightHeight, pixel, 0).xyz;
    receiver.plane = receiverPlane(receiver.lightHeight, map.widthScaleUv);
    receiver.bias = constantBias(receiver.uvDepth.z);
    return receiver;
}
