// Fails: Task6Edge.ATurnedSlabHidesAnExactShare, Task6Edge.ReceiverAndEdgeSpanAPlane, Task7WholeShadow.BoxesAgreeWithRays, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.StairsAgreeWithRays · the gradient's part along the ray is not taken away
float sceneDistance(vec3 p);

vec3 gradient(vec3 p, float delta) {
    vec2 e = vec2(delta, 0.0);
    return vec3(sceneDistance(p + e.xyy) - sceneDistance(p - e.xyy), sceneDistance(p + e.yxy) - sceneDistance(p - e.yxy),
                sceneDistance(p + e.yyx) - sceneDistance(p - e.yyx)) / (2.0 * delta);
}

vec3 edgePlane(float tangent, vec3 direction, vec3 gradient) {
    vec3 across = gradient;
    float size = length(across);
    return size < 1e-4 ? vec3(0.0) : tangent * direction + across / size;
}
