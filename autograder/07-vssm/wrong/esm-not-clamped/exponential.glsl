// Fails: Task7Exponential.TheExponentialShareIsClampedToOne, Task7Exponential.WholeFramesAreFilteredByTheWarps · the exponential share exceeds 1
#include "chebyshev.glsl"

float limitedExponent(float exponent, bool squared) { return min(exponent, squared ? 42.0 : 88.0); }

vec4 warpedMoments(float depth, float exponent) {
    float up = exp(exponent * depth), down = -exp(-exponent * depth);
    return vec4(up, up * up, down, down * down);
}

float esmLit(float meanWarped, float depth, float exponent) {
    return meanWarped / exp(exponent * depth);
}

float oneSide(vec2 moments, float warpedDepth, float exponent, float minVariance) {
    float slope = exponent * warpedDepth;
    return chebyshev(warpedDepth, vec2(moments.x, max(moments.y - moments.x * moments.x, minVariance * slope * slope)));
}

float evsmLit(vec4 meanWarped, float depth, float exponent, float minVariance) {
    return min(oneSide(meanWarped.xy, exp(exponent * depth), exponent, minVariance),
               oneSide(meanWarped.zw, -exp(-exponent * depth), exponent, minVariance));
}
