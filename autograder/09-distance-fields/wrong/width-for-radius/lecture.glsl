// Fails: Task3Lecture.ASlabsShadowFollowsTheFormula, Task3Lecture.BoxesAreAsFarFromRaysAsTheFormIs, Task3Lecture.TheLightsEdgeIsHalfAWidthAside, Task5Signed.ASlabsPenumbraIsALinearRamp, Task5Signed.AThinSlabLeaksByItsThickness, Task5Signed.BoxesAndFenceAgreeWithRays · the light's whole width is taken for half of it
float lightEdgeRatio(float width, float distance) { return width / distance; }

float lectureVisibility(float ratio, float edgeRatio, float k) { return clamp(k * ratio / edgeRatio, 0.0, 1.0); }

float safeTangent(float ratio) {
    float sine = clamp(ratio, -0.9999, 0.9999);
    return sine / sqrt(1.0 - sine * sine);
}
