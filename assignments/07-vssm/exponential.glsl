#include "chebyshev.glsl"

// Task 7a · the largest exponent that 32-bit floats bear.                                  README §7, [Annen 2008]
//   exponent   c >= 0 of exp(c depth), depth in [0,1]
//   squared    are squares of exp(c depth) kept, too?
// Returns c, or the limit where c is beyond it: a whole number below the one where infinity begins.
float limitedExponent(float exponent, bool squared) {
    return min(exponent, 1.0);  // yours; sound, and of little use
}

// Task 7b · two warps of the depth and their squares.                                      README §7, [Lauritzen 2008]
//   exponent   c, already limited
// Returns p, p², q, q² with p = exp(c depth) and q = -exp(-c depth): both grow with the depth.
vec4 warpedMoments(float depth, float exponent) {
    return vec4(0.0);  // yours
}

// Task 7c · exponential shadow maps.                                                       README §7, [Annen 2008]
//   meanWarped   mean of p over a box
//   depth        of the receiver, less its bias
// Returns the mean of exp(c (stored depth - depth)): about 1 where the stored depth is the receiver's, about 0 where it
// is nearer. At most 1.
float esmLit(float meanWarped, float depth, float exponent) {
    return 1.0;  // yours
}

// Task 7d · exponential variance shadow maps.                                              README §7, [Lauritzen 2008]
//   meanWarped    mean of warpedMoments() over a box
//   minVariance   of the depth; a warp multiplies it by the square of its slope at `depth`
// Returns the smaller of the two Chebyshev bounds: of p, and of q.
float evsmLit(vec4 meanWarped, float depth, float exponent, float minVariance) {
    return 1.0;  // yours
}
