// The scene from the light.
#include "area_shadow_map.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
out vec2 surfaceUv;

void main() {
    surfaceUv = uv;
    gl_Position = map.clipFromWorld * vec4(position, 1.0);
}
