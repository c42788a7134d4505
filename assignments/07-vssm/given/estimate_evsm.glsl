#include "warped_box.glsl"

float litShare(vec2 centerUv, vec2 widthUv, vec2 meanVariance, float depth) {
    return evsmLit(warpedBox(centerUv, widthUv), depth, limitedExponent(shadow.exponent, true), shadow.minVariance);
}
