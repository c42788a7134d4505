// Fails: Task3Lecture.TheSafeAnglesTangentStaysFinite · a ratio of 1 and more has no tangent: NaN
float lightEdgeRatio(float width, float distance) { return 0.5 * width / distance; }

float lectureVisibility(float ratio, float edgeRatio, float k) { return clamp(k * ratio / edgeRatio, 0.0, 1.0); }

float safeTangent(float ratio) {
    return ratio / sqrt(1.0 - ratio * ratio);
}
