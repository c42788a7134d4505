// Fails: Task7Exponential.EveryTexelIsWarpedFinitely, Task7Exponential.TheExponentKeepsFloatsFinite, Task7Exponential.WholeFramesAreFilteredByTheWarps · the exponent is not limited: Inf
#include "chebyshev.glsl"

float limitedExponent(float exponent, bool squared) { return exponent; }

vec4 warpedMoments(float depth, float exponent) {
    float up = exp(exponent * depth), down = -exp(-exponent * depth);
    return vec4(up, up * up, down, down * down);
}

float esmLit(float meanWarped, float depth, float exponent) {
    return clamp(meanWarped / exp(exponent * depth), 0.0, 1.0);
}

float oneSide(vec2 moments, float warpedDepth, float exponent, float minVariance) {
    float slope = exponent * warpedDepth;
    return chebyshev(warpedDepth, vec2(moments.x, max(moments.y - moments.x * moments.x, minVariance * slope * slope)));
}

float evsmLit(vec4 meanWarped, float depth, float exponent, float minVariance) {
    return min(oneSide(meanWarped.xy, exp(exponent * depth), exponent, minVariance),
               oneSide(meanWarped.zw, -exp(-exponent * depth), exponent, minVariance));
}
