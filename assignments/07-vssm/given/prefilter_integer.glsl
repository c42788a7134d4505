// The table in integers modulo 2^32. The sum over a box of whole texels is exact, whatever has wrapped around on the
// way, as long as that sum itself is below 2^31. A box with parts of texels is a weighted sum of such boxes: its left
// edge lies between two columns, and so on. Differences come first, in integers; weights after, in floats.
#include "each_box.glsl"

uniform usampler2D integers;

// Sum over all texels left of column x and below row y.
uvec2 integersAt(int x, int y) {
    uvec2 sum = texelFetch(integers, max(ivec2(x, y) - 1, ivec2(0)), 0).xy;
    return x > 0 && y > 0 ? sum : uvec2(0u);
}

vec2 meanInside(vec2 low, vec2 high) {
    ivec2 l = ivec2(low), h = ivec2(high), last = ivec2(1.0 / map.texelSizeUv + 0.5);
    ivec4 x = min(ivec4(l.x, l.x + 1, h.x, h.x + 1), ivec4(last.x));  // whole columns on both sides of each edge
    ivec4 y = min(ivec4(l.y, l.y + 1, h.y, h.y + 1), ivec4(last.y));
    vec2 lowPart = low - vec2(l), highPart = high - vec2(h);
    vec4 weightX = vec4(lowPart.x - 1.0, -lowPart.x, 1.0 - highPart.x, highPart.x);
    vec4 weightY = vec4(lowPart.y - 1.0, -lowPart.y, 1.0 - highPart.y, highPart.y);
    uvec2 below[4] = uvec2[4](integersAt(x.x, y.x), integersAt(x.y, y.x), integersAt(x.z, y.x), integersAt(x.w, y.x));
    vec2 sum = vec2(0.0);
    for (int j = 1; j < 4; ++j) {
        uvec2 left = integersAt(x[0], y[j]);
        for (int i = 1; i < 4; ++i)
            sum += weightX[i] * weightY[j] * vec2(ivec2(integersAt(x[i], y[j]) - left - below[i] + below[0]));
    }
    vec2 width = high - low;
    return sum / (shadow.integersPerUnit * max(width.x * width.y, 1e-6));
}
