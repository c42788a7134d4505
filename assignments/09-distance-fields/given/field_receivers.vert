// A surface as the camera sees it.
#include "camera.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
out vec3 worldPosition;
out vec3 vertexNormal;
out vec2 surfaceUv;

void main() {
    worldPosition = position;
    vertexNormal = normal;
    surfaceUv = uv;
    gl_Position = camera.clipFromWorld * vec4(position, 1.0);
}
