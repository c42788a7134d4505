#include "error_function.glsl"

// Task 4a · at most what share of a box is at `depth` or farther?                          README §4, [Donnelly 2006]
//   depth          of the receiver, less its bias
//   meanVariance   of the box's depths; the variance may be 0
// Returns the one-sided Chebyshev (Cantelli) bound: 1 where the receiver is not beyond the mean; no NaN at variance 0.
float chebyshev(float depth, vec2 meanVariance) {
    return 1.0;  // yours
}

// Task 4b · less light where there should be none.                                         README §4, [Lauritzen 2007]
//   amount   0 … 0.9
// Returns 0 up to `amount`, 1 at 1, a straight line between, and nothing outside [0, 1].
float lessBleeding(float bound, float amount) {
    return bound;  // yours
}

// Task 4c · the same share, if the depths were normally distributed.                       README §4
// Returns 1 - Phi((depth - mean) / deviation), one half at the mean. A deviation of 0 is no NaN: it answers almost 1 or
// 0 beside the mean. errorFunction() is given.
float normalTail(float depth, vec2 meanVariance) {
    return 1.0;  // yours
}
