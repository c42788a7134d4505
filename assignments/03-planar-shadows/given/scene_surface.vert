// A surface as the camera sees it. Drawn twice, for visibility and for colour, with the same depth.
#include "camera.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
out vec3 worldPosition;
out vec3 vertexNormal;
out vec2 surfaceUv;
invariant gl_Position;

void main() {
    worldPosition = position;
    vertexNormal = normal;
    surfaceUv = uv;
    gl_Position = camera.clipFromWorld * vec4(position, 1.0);
}
