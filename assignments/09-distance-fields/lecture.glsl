// Task 3a · where the light's edge is.                                                     README §3
//   width      full width of the light, which faces the receiver                           [world]
//   distance   from the receiver to its centre, > 0                                        [world]
// Returns the tangent of the angle between the light's centre and its edge.
float lightEdgeRatio(float width, float distance) {
    return 0.08;  // yours; right nowhere
}

// Task 3b · the lecture's soft shadow.                                                     README §3, [Quilez 2010]
//   ratio       smallest distance / t on the ray; 0 or less where it meets a blocker
//   edgeRatio   > 0, what 3a returns
//   k           sharpness in units of 1 / edgeRatio
// Returns [0,1]: 0 where the centre's ray is blocked, 1 where ratio is edgeRatio / k or more.
float lectureVisibility(float ratio, float edgeRatio, float k) {
    return 1.0;  // yours
}

// Task 3c · the safe angle.                                                                README §3
//   ratio   smallest distance / t on the ray, in (-1, 1)
// A sphere of radius `distance` around the ray's point at t touches no blocker (or is filled by one). Returns the tangent
// of the angle between the ray and the cone around that sphere, with ratio's sign; finite for every input.
float safeTangent(float ratio) {
    return 0.0;  // yours
}
