// method=closest_approach
#include "closest_approach.glsl"

vec2 approachSince(float before, float here, float stepTaken) { return closestApproach(before, here, stepTaken); }
