// One of the passes that turn texels into a summed-area table.
#include "sat.glsl"

uniform vec2 axis;  // (1, 0) or (0, 1)
uniform int pass;
layout(location = 0) out uvec2 sum;

void main() { sum = sumOfFour(ivec2(gl_FragCoord.xy), ivec2(axis) * strideOfPass(pass)); }
