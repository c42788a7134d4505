// Fails: Task2ReceiverPlane.ABlockerIsBeforeTheReceiverAndOverItsPlane · what is nearer, or over the plane, by just the bias blocks: without bias a surface blocks itself
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return -offset.z >= bias && dot(plane, offset) >= bias * abs(plane.z);
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return lightHeight.x + dot(lightHeight.yz, lightPoint) > 0.0; }
