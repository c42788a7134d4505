// Fails: Task1Distance.ASliceShowsTheDistanceToEveryTriangle, Task1Distance.BeyondTheGridTheBoundIsTheLargestSoundOne · both ways are added up beyond the grid: farther than the blocker may be
float sphereDistance(vec3 p, vec3 center, float radius) { return length(p - center) - radius; }

float boxDistance(vec3 p, vec3 center, vec3 halfSize) {
    vec3 beyond = abs(p - center) - halfSize;
    return length(max(beyond, 0.0)) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0);
}

vec3 fieldCoordinate(vec3 p, vec3 lower, vec3 upper) { return (p - lower) / (upper - lower); }

float distanceBeyond(vec3 p, vec3 onBox, float distanceThere) {
    vec3 beyond = p - onBox;
    float squared = dot(beyond, beyond);
    return squared > 0.0 ? sqrt(squared) + distanceThere : distanceThere;
}
