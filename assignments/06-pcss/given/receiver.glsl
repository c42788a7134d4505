// What the surface pass has left of the receiver in this pixel.
#include "soft_shadow.glsl"
#include "receiver_plane.glsl"

uniform sampler2D receiverPosition;  // u, v, depth; w: 1 a surface before the light, 0 one in the dark, -1 none
uniform sampler2D receiverPlaneAt;   // lightHeight

Receiver receiverAt(ivec2 pixel, out float kind) {
    vec4 position = texelFetch(receiverPosition, pixel, 0);
    Receiver receiver;
    receiver.uvDepth = position.xyz;
    receiver.lightHeight = texelFetch(receiverPlaneAt, pixel, 0).xyz;
    receiver.plane = receiverPlane(receiver.lightHeight, soft.widthScaleUv);
    receiver.bias = soft.biasAtZero + soft.biasSlope * position.z;
    kind = position.w;
    return receiver;
}
