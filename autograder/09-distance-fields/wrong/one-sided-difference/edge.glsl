// Fails: Task6Edge.TheGradientPointsAwayFromTheNearestPoint · differences to one side: half a step beside
float sceneDistance(vec3 p);

vec3 gradient(vec3 p, float delta) {
    vec2 e = vec2(delta, 0.0);
    return vec3(sceneDistance(p + e.xyy) - sceneDistance(p), sceneDistance(p + e.yxy) - sceneDistance(p),
                sceneDistance(p + e.yyx) - sceneDistance(p)) / delta;
}

vec3 edgePlane(float tangent, vec3 direction, vec3 gradient) {
    vec3 across = gradient - dot(gradient, direction) * direction;
    float size = length(across);
    return size < 1e-4 ? vec3(0.0) : tangent * direction + across / size;
}
