// Two look-ups in the float32 table for each side, four for each box.
#include "variance_shadow.glsl"
#include "box.glsl"

uniform sampler2D table;

vec2 tableAt(vec2 corner) { return textureLod(table, tableUv(corner, map.texelSizeUv), 0.0).xy; }

Side sideAt(vec2 low, vec2 high) { return Side(low, high, tableAt(low), tableAt(high)); }

// At whole corners nothing is interpolated.
vec2 tableAtCorner(vec2 corner) {
    ivec2 texel = ivec2(corner) - 1;
    vec2 sum = texelFetch(table, max(texel, ivec2(0)), 0).xy;
    return min(texel.x, texel.y) < 0 ? vec2(0.0) : sum;
}

Side wholeSideAt(vec2 low, vec2 high) { return Side(low, high, tableAtCorner(low), tableAtCorner(high)); }

vec2 meanBetween(Side left, Side right) {
    vec2 width = right.high - left.low;
    return boxSum(left.below, right.below, left.above, right.above) / max(width.x * width.y, 1e-6);
}
