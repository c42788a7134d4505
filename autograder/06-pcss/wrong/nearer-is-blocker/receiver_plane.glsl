// Fails: Task2ReceiverPlane.ABlockerIsBeforeTheReceiverAndOverItsPlane, Task2ReceiverPlane.NoFalseShadowOnAPlaneFrom10To89Degrees, Task5Pcss.ATinyLightCastsAHardShadowAndAHugeOneStaysFinite, Task5Pcss.TheHorizonIsCountedOnce, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays, Task9Backprojection.FenceAndStairsAgreeWithRays, Task9Backprojection.TheHorizonIsAClosedForm · the receiver's plane is never asked
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return -offset.z > bias;
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return lightHeight.x + dot(lightHeight.yz, lightPoint) > 0.0; }
