// Sums in float32: the table is filtered linearly, which is exact for a box with fractions of a texel at its sides.
#include "moment_shadow.glsl"

uniform sampler2D sums;  // see render/summed_area_table.h

vec4 meanStored(vec2 lowUv, vec2 highUv) {
    vec4 at = vec4(lowUv, highUv) - 0.5 * map.texelSizeUv.xyxy;
    vec2 texels = (highUv - lowUv) / map.texelSizeUv;
    vec4 upper = textureLod(sums, at.zw, 0.0) - textureLod(sums, at.xw, 0.0);
    vec4 lower = textureLod(sums, at.zy, 0.0) - textureLod(sums, at.xy, 0.0);
    return (upper - lower) / (texels.x * texels.y);
}

vec4 meanStoredAround(vec2 lowUv, vec2 highUv) {
    vec2 low = floor(lowUv / map.texelSizeUv), high = ceil(highUv / map.texelSizeUv);
    return meanStored(low * map.texelSizeUv, high * map.texelSizeUv);
}
