// Fails: Task4Bound.LessBleedingKeepsZeroAndOne, Task6SoftShadows.WhereNothingBlocksTheHorizonAloneCounts · the bound is cut, but what is left does not reach 1
#include "error_function.glsl"

float chebyshev(float depth, vec2 meanVariance) {
    float beyond = depth - meanVariance.x;
    if (beyond <= 0.0) return 1.0;
    return meanVariance.y / (meanVariance.y + beyond * beyond);
}

float lessBleeding(float bound, float amount) { return max(bound - amount, 0.0); }

float normalTail(float depth, vec2 meanVariance) {
    float deviation = sqrt(max(meanVariance.y, 1e-20));
    return 0.5 - 0.5 * errorFunction((depth - meanVariance.x) / (deviation * 1.4142135624));
}
