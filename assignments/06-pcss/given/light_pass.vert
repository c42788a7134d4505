// The scene from the light.
#include "soft_shadow.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
out vec2 surfaceUv;

void main() {
    surfaceUv = uv;
    gl_Position = soft.clipFromWorld * vec4(position, 1.0);
}
