// Sums modulo 2^32: a difference is exact, however large the sums. So differences come first, fractions after. Along
// one axis, with P(k) the sum over all texels below k, and P(k + f) = P(k) + f (P(k + 1) - P(k)) between them:
//
//   from low + f to high + g:   (1 - g) (P(high) - P(low))  +  g (P(high + 1) - P(low))  -  f (P(low + 1) - P(low))
//
// and in two dimensions the product of two such lines: nine boxes, each with its lower corner at `low`.
#include "moment_shadow.glsl"

uniform usampler2D sums;  // see render/summed_area_table.h: 0 beyond the border

uvec4 sumBelow(float x, float y) { return textureLod(sums, (vec2(x, y) - 0.5) * map.texelSizeUv, 0.0); }

struct Columns {
    uvec4 low, lowNext, high, highNext;
};

Columns columnsBelow(vec2 x, float y) {
    return Columns(sumBelow(x.x, y), sumBelow(x.x + 1.0, y), sumBelow(x.y, y), sumBelow(x.y + 1.0, y));
}

// Weighted sum over the row of boxes between two rows of corners.
vec4 rowSum(Columns a, Columns b, vec3 weight) {
    uvec4 left = b.low - a.low;
    return weight.x * vec4(ivec4(b.lowNext - a.lowNext - left)) + weight.y * vec4(ivec4(b.high - a.high - left)) +
           weight.z * vec4(ivec4(b.highNext - a.highNext - left));
}

vec4 meanStored(vec2 lowUv, vec2 highUv) {
    vec2 low = lowUv / map.texelSizeUv, high = highUv / map.texelSizeUv, f = fract(low), g = fract(high);
    vec2 x = floor(vec2(low.x, high.x)), y = floor(vec2(low.y, high.y));
    vec3 across = vec3(-f.x, 1.0 - g.x, g.x);
    Columns first = columnsBelow(x, y.x);
    vec4 sum = -f.y * rowSum(first, columnsBelow(x, y.x + 1.0), across);
    sum += (1.0 - g.y) * rowSum(first, columnsBelow(x, y.y), across);
    sum += g.y * rowSum(first, columnsBelow(x, y.y + 1.0), across);
    return sum * (soft.unitsPerInteger / ((high.x - low.x) * (high.y - low.y)));
}

vec4 meanStoredAround(vec2 lowUv, vec2 highUv) {
    vec2 low = floor(lowUv / map.texelSizeUv), high = ceil(highUv / map.texelSizeUv);
    uvec4 sum = sumBelow(high.x, high.y) - sumBelow(low.x, high.y) - sumBelow(high.x, low.y) + sumBelow(low.x, low.y);
    return vec4(ivec4(sum)) * (soft.unitsPerInteger / ((high.x - low.x) * (high.y - low.y)));
}
