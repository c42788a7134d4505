// A shape with a known distance, for a function that is graded alone. A sphere where halfSize is 0.
vec3 shapeCenter, shapeHalfSize;
float shapeRadius;

float sceneDistance(vec3 p) {
    vec3 q = abs(p - shapeCenter) - shapeHalfSize;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - shapeRadius;
}
