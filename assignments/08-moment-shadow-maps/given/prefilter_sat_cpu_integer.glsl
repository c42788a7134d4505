// Sums modulo 2^32: a difference is exact, however large the sums. So differences come first, fractions after. Along
// one axis, with P(k) the sum over all texels below k, and a side at i + f, the linear P(i) + f (P(i + 1) - P(i)):
//
//   from i0 + f0 to i1 + f1:   (1 - f1) (P(i1) - P(i0))  +  f1 (P(i1 + 1) - P(i0))  -  f0 (P(i0 + 1) - P(i0))
//
// and in two dimensions the product of two such lines: nine boxes, all with their lower corner at i0.
#include "moment_shadow.glsl"

uniform usampler2D sums;  // see render/summed_area_table.h

uvec4 sumBelow(ivec2 corner) {
    ivec2 at = min(corner, textureSize(sums, 0)) - 1;
    return min(at.x, at.y) < 0 ? uvec4(0u) : texelFetch(sums, at, 0);
}

vec4 meanStored(vec2 lowUv, vec2 highUv) {
    vec2 lowTexels = lowUv / map.texelSizeUv, highTexels = highUv / map.texelSizeUv;
    ivec2 low = ivec2(lowTexels), high = ivec2(highTexels);
    vec2 lowPart = lowTexels - vec2(low), highPart = highTexels - vec2(high);
    vec3 across = vec3(-lowPart.x, 1.0 - highPart.x, highPart.x);
    vec3 along = vec3(-lowPart.y, 1.0 - highPart.y, highPart.y);
    ivec4 columns = ivec4(low.x, low.x + 1, high.x, high.x + 1), rows = ivec4(low.y, low.y + 1, high.y, high.y + 1);
    uvec4 first[4];
    vec4 sum = vec4(0.0);
    for (int j = 0; j < 4; ++j) {
        uvec4 left = sumBelow(ivec2(columns[0], rows[j]));
        vec4 row = vec4(0.0);
        for (int i = 1; i < 4; ++i) {
            uvec4 box = sumBelow(ivec2(columns[i], rows[j])) - left;
            if (j == 0) first[i] = box;
            else row += across[i - 1] * vec4(ivec4(box - first[i]));
        }
        if (j > 0) sum += along[j - 1] * row;
    }
    vec2 texels = highTexels - lowTexels;
    return sum * (soft.unitsPerInteger / (texels.x * texels.y));
}
