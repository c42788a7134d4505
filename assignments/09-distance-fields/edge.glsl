float sceneDistance(vec3 p);   // given: to the nearest blocker, negative inside

// Task 6a · which way the distance grows.                                                  README §6
//   delta   > 0, half the way between two look-ups                                         [world]
// Returns the gradient of sceneDistance at p by central differences, as long as it is: 1 where the field is smooth.
vec3 gradient(vec3 p, float delta) {
    return vec3(0.0);  // yours
}

// Task 6b · the plane through the receiver and the blocker's edge.                         README §6
//   tangent     of the angle from the ray to the edge, negative where the ray is blocked: 3c
//   direction   of the ray, unit
//   gradient    at the closest approach, of any length
// The edge is straight, at right angles to the ray and to the gradient. Returns a normal of the plane through it and the
// receiver, whose part at right angles to the ray has length 1: light points l, relative to the receiver, are visible
// where dot(normal, l) > 0. vec3(0.0) where the gradient's part at right angles to the ray is shorter than 1e-4.
vec3 edgePlane(float tangent, vec3 direction, vec3 gradient) {
    return vec3(0.0);  // yours
}
