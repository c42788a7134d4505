// Fails: Task3Lecture.TheSafeAnglesTangentStaysFinite, Task5Signed.ARayAlongTheSurfaceSeesHalfTheLight · the safe angle's sine is taken for its tangent
float lightEdgeRatio(float width, float distance) { return 0.5 * width / distance; }

float lectureVisibility(float ratio, float edgeRatio, float k) { return clamp(k * ratio / edgeRatio, 0.0, 1.0); }

float safeTangent(float ratio) {
    float sine = clamp(ratio, -0.9999, 0.9999);
    return sine;
}
