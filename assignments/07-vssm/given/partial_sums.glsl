// What the pass before has left.
uniform usampler2D partialSums;

uvec2 partialSum(ivec2 texel) { return texelFetch(partialSums, texel, 0).xy; }
