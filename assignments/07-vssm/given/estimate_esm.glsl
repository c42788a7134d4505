#include "warped_box.glsl"

float litShare(vec2 centerUv, vec2 widthUv, vec2 meanVariance, float depth) {
    return esmLit(warpedBox(centerUv, widthUv).x, depth, limitedExponent(shadow.exponent, false));
}
