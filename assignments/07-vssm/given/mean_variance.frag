// Around each texel's centre, a box of filter_width.
#include "windows.glsl"

layout(location = 0) out vec2 result;

void main() {
    Window window = windowAround(gl_FragCoord.xy * map.texelSizeUv, shadow.filterWidthUv, 1.0);
    result = meanVarianceBetween(window, sideOf(window, 0, 0), sideOf(window, 1, 0));
}
