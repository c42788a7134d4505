// Fails: Task2ReceiverPlane.NoFalseShadowOnAPlaneFrom10To89Degrees, Task2ReceiverPlane.TellsWhichPointsLieOverThePlane, Task5Pcss.ATinyLightCastsAHardShadowAndAHugeOneStaysFinite, Task5Pcss.TheHorizonIsCountedOnce, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.StairsAgreeWithRays, Task9Backprojection.FenceAndStairsAgreeWithRays, Task9Backprojection.TheHorizonIsAClosedForm · the plane's sign is lost: what is below counts as over it
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(-lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return -offset.z > bias && dot(plane, offset) > bias * abs(plane.z);
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return lightHeight.x + dot(lightHeight.yz, lightPoint) > 0.0; }
