// Fails: Task2ReceiverPlane.TheHorizonCutsTheLight, Task5Pcss.FiltersAsTheSearchSays, Task5Pcss.TheHorizonIsCountedOnce, Task8WholeShadow.BoxesAgreeWithRays · the light is up or down as a whole, as its centre is
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return -offset.z > bias && dot(plane, offset) > bias * abs(plane.z);
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return lightHeight.x > 0.0; }
