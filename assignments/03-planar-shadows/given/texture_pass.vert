// Casters from the light.
#include "planar.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
out vec2 surfaceUv;

void main() {
    surfaceUv = uv;
    gl_Position = planar.textureClipFromWorld * vec4(position, 1.0);
}
