// Second depth layer: what is left when the first surface is peeled off.
#include "shadow_map.glsl"
#include "second_depth.glsl"
#include "material.glsl"

in vec2 surfaceUv;
uniform sampler2D firstDepth;

void main() {
    if (isHole(surfaceUv)) discard;
    float first = texelFetch(firstDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (isFirstSurface(gl_FragCoord.z, first, map.depthResolution)) discard;
}
