// Fails: Task2ReceiverPlane.ABlockerIsBeforeTheReceiverAndOverItsPlane, Task2ReceiverPlane.NoFalseShadowOnAPlaneFrom10To89Degrees, Task9Backprojection.TheHorizonIsAClosedForm · what lies behind the receiver may block it
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return dot(plane, offset) > bias * abs(plane.z);
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return lightHeight.x + dot(lightHeight.yz, lightPoint) > 0.0; }
