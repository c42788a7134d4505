// Fails: Task2ReceiverPlane.TheHorizonCutsTheLight · light points on the receiver's plane count as seen
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return -offset.z > bias && dot(plane, offset) > bias * abs(plane.z);
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return lightHeight.x + dot(lightHeight.yz, lightPoint) >= 0.0; }
