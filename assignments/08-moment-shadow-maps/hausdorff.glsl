#include "hamburger.glsl"

// Task 5 · the same, knowing that no depth lies outside [-1,1].                            README §5, [Peters and Klein 2015]
// Where 3a's other points both lie in [-1,1], returns what 3b returns. Else there is one distribution of four points -1, t,
// x, 1 that has the moments b: returns the share of its points nearer than t, and their mean depth.
Blockers hausdorffBlockers(vec4 b, float t) {
    return hamburgerBlockers(b, t);  // yours
}
