// The receiver in this pixel, as your functions take it.
#include "receivers.glsl"
#include "moment_shadow.glsl"

vec4 lightRectangle(vec3 height);  // horizon
float lightShare(vec3 height);

Receiver receiverAt(ivec2 pixel) {
    Receiver receiver;
    receiver.uvDepth = texelFetch(receiverPosition, pixel, 0).xyz;
    receiver.lightHeight = texelFetch(receiverLightHeight, pixel, 0).xyz;
    receiver.light = lightRectangle(receiver.lightHeight);
    receiver.lightShare = lightShare(receiver.lightHeight);
    receiver.bias = constantBias(receiver.uvDepth.z);
    return receiver;
}
