// Fails: Task4Bound.TheNormalTailIsWhatLiesBeyond, Task6SoftShadows.TheFilterAsksTheChosenEstimate · the share nearer than the receiver is taken for the share beyond it
#include "error_function.glsl"

float chebyshev(float depth, vec2 meanVariance) {
    float beyond = depth - meanVariance.x;
    if (beyond <= 0.0) return 1.0;
    return meanVariance.y / (meanVariance.y + beyond * beyond);
}

float lessBleeding(float bound, float amount) { return clamp((bound - amount) / (1.0 - amount), 0.0, 1.0); }

float normalTail(float depth, vec2 meanVariance) {
    float deviation = sqrt(max(meanVariance.y, 1e-20));
    return 0.5 + 0.5 * errorFunction((depth - meanVariance.x) / (deviation * 1.4142135624));
}
