// What the pass before has left. Sizes are powers of two; beyond a border the texels repeat.
uniform usampler2D partialSums;

uvec2 partialSum(ivec2 texel) { return texelFetch(partialSums, texel & (textureSize(partialSums, 0) - 1), 0).xy; }
