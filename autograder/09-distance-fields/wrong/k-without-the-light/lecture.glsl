// Fails: Task3Lecture.ASlabsShadowFollowsTheFormula, Task3Lecture.BoxesAreAsFarFromRaysAsTheFormIs, Task3Lecture.VisibilityRisesFromTheRayToTheLightsEdge · the lecture's k as a bare number: shadows are as soft for every light
float lightEdgeRatio(float width, float distance) { return 0.5 * width / distance; }

float lectureVisibility(float ratio, float edgeRatio, float k) { return clamp(k * ratio, 0.0, 1.0); }

float safeTangent(float ratio) {
    float sine = clamp(ratio, -0.9999, 0.9999);
    return sine / sqrt(1.0 - sine * sine);
}
