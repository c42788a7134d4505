// Two look-ups in the float32 table for each side, four for each box.
#include "variance_shadow.glsl"
#include "box.glsl"

uniform sampler2D table;

vec2 tableAt(vec2 corner) { return textureLod(table, tableUv(corner, map.texelSizeUv), 0.0).xy; }

Side sideAt(vec2 low, vec2 high) { return Side(low, high, tableAt(low), tableAt(high)); }

vec2 meanBetween(Side left, Side right) {
    vec2 width = right.high - left.low;
    return boxSum(left.below, right.below, left.above, right.above) / max(width.x * width.y, 1e-6);
}
