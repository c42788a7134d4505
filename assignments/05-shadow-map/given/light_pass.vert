// The scene from the light, through your light clip position.
#include "shadow_map.glsl"
#include "shadow_coordinates.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
out vec2 surfaceUv;

void main() {
    surfaceUv = uv;
    gl_Position = lightClipPosition(position, map.clipFromWorld);
}
