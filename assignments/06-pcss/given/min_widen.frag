// Each texel takes the smallest depth in the widest search window around any of its points, along one axis.
#include "soft_shadow.glsl"
#include "min_pyramid.glsl"

uniform sampler2D narrow;
uniform vec2 axis;
layout(location = 0) out float nearest;

void main() {
    int radius = windowRadiusTexels(dot(axis, map.widthScaleUv), soft.minTexelUv);
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(narrow, 0) - 1;
    nearest = 1.0;
    for (int i = -radius; i <= radius; ++i)
        nearest = min(nearest, texelFetch(narrow, clamp(here + i * ivec2(axis), ivec2(0), last), 0).r);
}
