#include "moment_shadow.glsl"

// Task 3a · with a point at t, where do the other two lie?                                 README §3, [Peters and Klein 2015]
//   b   moments of depths in [-1,1], biased
//   t   a depth
// There is one distribution of three points, one of them at t, that has the moments b. Returns the other two points, the
// smaller first. They may lie outside [-1,1], and as far as ±10⁶; what would lie farther is put there. Finite for every
// b with E[z²] ≥ E[z]², and for every t in [-1,1].
vec2 otherDepths(vec4 b, float t) {
    return vec2(-1.0, 1.0);  // yours
}

// Task 3b · how much is nearer than t, at the least?                                       README §3, [Peters and Klein 2015]
// Returns the weights of those points of 3a's distribution that are nearer than t, added up, in [0,1]: no distribution
// with these moments has less before t. And their mean depth, in [-1,t]; 0 where the share is 0.
Blockers hamburgerBlockers(vec4 b, float t) {
    return Blockers(0.0, 0.0);  // yours
}
