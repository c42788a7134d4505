#include "moment_shadow.glsl"

float comparedDepth(Receiver receiver, float blockerDepth) {
    vec2 slope = receiver.lightHeight.yz, lowest = mix(receiver.light.zw, receiver.light.xy, greaterThan(slope, vec2(0.0)));
    float fall = clamp(-dot(slope, lowest) / max(receiver.lightHeight.x, 1e-6), 0.0, 1.0);
    return receiver.uvDepth.z - receiver.bias - 0.75 * fall * max(receiver.uvDepth.z - blockerDepth, 0.0);
}
