// Mean of the warped moments over a box. From mip levels: a table's sums would be of the size of the largest exponential
// in the map, and a box of small ones be lost in their rounding.
#include "variance_shadow.glsl"
#include "mip_levels.glsl"
#include "exponential.glsl"

uniform sampler2D warped;

vec4 warpedBox(vec2 centerUv, vec2 widthUv) {
    return mipMean(warped, (centerUv - 0.5 * widthUv) / map.texelSizeUv, (centerUv + 0.5 * widthUv) / map.texelSizeUv);
}
