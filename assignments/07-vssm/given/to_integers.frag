// Moments as whole numbers, negative ones modulo 2^32.
#include "variance_shadow.glsl"

uniform sampler2D moments;
layout(location = 0) out uvec2 whole;

void main() {
    vec2 value = texelFetch(moments, ivec2(gl_FragCoord.xy), 0).xy;
    whole = uvec2(ivec2(floor(value * shadow.integersPerUnit + 0.5)));
}
