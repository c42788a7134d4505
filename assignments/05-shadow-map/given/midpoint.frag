#include "second_depth.glsl"

uniform sampler2D firstDepth;
uniform sampler2D secondDepth;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    gl_FragDepth = midpointDepth(texelFetch(firstDepth, texel, 0).r, texelFetch(secondDepth, texel, 0).r);
}
