// Both widths are full widths in the map [uv], along u and along v. No distances are needed: with a depth d in [0,1]
// of a perspective view, the light's parallax at depth d before a receiver at depth r is widthScaleUv * (r - d).
//   widthScaleUv    S: how wide the light is, seen through a depth difference of 1           [uv]

// Task 1a · where blockers can be.                                                         README §1
//   receiverDepth   [0,1]; beyond 1 behind the far plane
// Returns the width of the window that holds whatever can block: blockers lie between the near plane (depth 0) and the
// receiver. At least 0.
vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) {
    return vec2(0.0);  // yours
}

// Task 1b · how wide the light is, seen from the receiver through the blocker's plane.     README §1, [Fernando 2005]
//   blockerDepth    [0,1]; nearer than the receiver, or as near
// Returns 0 at contact, and never less.
vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return vec2(0.0);  // yours
}
