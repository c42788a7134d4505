// Fails: Task4SoftShadow.ComparesBelowTheReceiversPlane, Task4SoftShadow.EachCellIsComparedBelowItsPartOfThePlane, Task4SoftShadow.WithoutABlockerOnlyTheHorizonCutsTheLight, Task6WholeShadow.BoxesAgreeWithRays, Task6WholeShadow.SixteenBitsAreEnough · the receiver's plane is not asked
#include "moment_shadow.glsl"

float comparedDepth(Receiver receiver, float blockerDepth) {
    vec2 slope = receiver.lightHeight.yz, lowest = mix(receiver.light.zw, receiver.light.xy, greaterThan(slope, vec2(0.0)));
    float drop = -dot(slope, lowest), height = receiver.lightHeight.x;
    float fall = drop <= 0.0 ? 0.0 : drop >= height ? 1.0 : drop / height;
    return receiver.uvDepth.z - receiver.bias;
}
