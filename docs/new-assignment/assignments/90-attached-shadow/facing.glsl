// Task 1 · attached shadow.                                                              README §1
//   facet     unit normal of the receiver's plane, on the eye's side
//   toLight   from the receiver to the light, any length > 0                             [world]
// Returns visibility: 1 where the light lies above the plane, 0 on it and below.
float facingVisibility(vec3 facet, vec3 toLight) {
    return 1.0;  // yours
}
