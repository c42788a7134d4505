// A surface as the camera sees it.
#include "clip_position.glsl"

layout(location = 0) in vec4 position;  // w = 1: the buffer holds three coordinates
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
out vec3 worldPosition;
out vec3 vertexNormal;
out vec2 surfaceUv;

void main() {
    worldPosition = position.xyz;
    vertexNormal = normal;
    surfaceUv = uv;
    gl_Position = clipPosition(position);
}
