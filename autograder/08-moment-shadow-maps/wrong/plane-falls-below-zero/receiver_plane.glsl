// Fails: Task4SoftShadow.ComparesBelowTheReceiversPlane, Task4SoftShadow.EachCellIsComparedBelowItsPartOfThePlane · where all of the plane lies behind the receiver, the depth compared with does, too
#include "moment_shadow.glsl"

float comparedDepth(Receiver receiver, float blockerDepth) {
    vec2 slope = receiver.lightHeight.yz, lowest = mix(receiver.light.zw, receiver.light.xy, greaterThan(slope, vec2(0.0)));
    float drop = -dot(slope, lowest), height = receiver.lightHeight.x;
    float fall = drop >= height ? 1.0 : drop / height;
    return receiver.uvDepth.z - receiver.bias - 0.75 * fall * max(receiver.uvDepth.z - blockerDepth, 0.0);
}
