// A surface as the camera sees it, with its place in the light's view.
#include "camera.glsl"
#include "area_shadow_map.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
out vec3 worldPosition;
out vec3 vertexNormal;
out vec2 surfaceUv;
out vec4 lightClip;  // homogeneous: interpolates exactly

void main() {
    worldPosition = position;
    vertexNormal = normal;
    surfaceUv = uv;
    lightClip = map.clipFromWorld * vec4(position, 1.0);
    gl_Position = camera.clipFromWorld * vec4(position, 1.0);
}
