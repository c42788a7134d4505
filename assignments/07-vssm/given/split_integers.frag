// 32-bit integers for images of floats: upper and lower 16 bits of both sums.
uniform usampler2D integers;
layout(location = 0) out vec4 halves;

void main() {
    uvec2 sum = texelFetch(integers, ivec2(gl_FragCoord.xy), 0).xy;
    halves = vec4(sum.x >> 16u, sum.x & 0xffffu, sum.y >> 16u, sum.y & 0xffffu);
}
