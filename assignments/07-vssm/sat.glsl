#include "partial_sums.glsl"

// Task 2a · how far apart are the texels that a pass adds up?                              README §2, [Crow 1984]
//   pass   0, 1, 2, …
// Returns how many texels one partial sum holds when that pass begins [texels]: 1 before the first.
int strideOfPass(int pass) {
    return 1;  // yours
}

// Task 2b · one pass: each texel takes up what stands before it.                           README §2, [Hensley 2005]
//   texel   this one
//   step    (stride, 0) where rows are summed, (0, stride) where columns are               [texels]
// Returns the sum of four partial sums: partialSum() of this texel, and of the three that lie one, two and three steps
// before it. Texels before the border (a coordinate below 0) count as 0: partialSum() must not be asked for them.
uvec2 sumOfFour(ivec2 texel, ivec2 step) {
    return partialSum(texel);  // yours
}
