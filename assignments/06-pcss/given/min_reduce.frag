// One level of the pyramid from the next finer one.
#include "min_pyramid.glsl"

uniform sampler2D finer;
layout(location = 0) out float nearest;

void main() {
    ivec2 first = 2 * ivec2(gl_FragCoord.xy);
    nearest = nearestOfFour(vec4(texelFetch(finer, first, 0).r, texelFetch(finer, first + ivec2(1, 0), 0).r,
                                 texelFetch(finer, first + ivec2(0, 1), 0).r, texelFetch(finer, first + ivec2(1, 1), 0).r));
}
