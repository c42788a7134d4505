// A horizontal slice through the field, a quarter wider than the grid's box at each side. Row 0 on top: the lowest z.
#include "field.glsl"

layout(location = 0) out float distance;  // [world]

void main() {
    vec2 uv = vec2(gl_FragCoord.x, 256.0 - gl_FragCoord.y) / 256.0;
    vec3 size = field.upper - field.lower;
    vec2 xz = field.lower.xz + (1.5 * uv - 0.25) * size.xz;
    distance = sceneDistance(vec3(xz.x, field.sliceY, xz.y));
}
