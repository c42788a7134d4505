// Fails: Task2ReceiverPlane.TheHorizonCutsTheLight, Task5Pcss.FiltersAsTheSearchSays, Task5Pcss.TheHorizonIsCountedOnce, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FoliageAgreesWithRays · the light is never cut by the receiver's own plane
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) { return vec3(lightHeight.yz / widthScaleUv, -lightHeight.x); }

bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return -offset.z > bias && dot(plane, offset) > bias * abs(plane.z);
}

bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) { return true; }
