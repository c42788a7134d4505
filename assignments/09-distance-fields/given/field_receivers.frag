// What the camera sees, before any shadow: its light, its place in the world, and the light over its plane.
#include "camera.glsl"
#include "shading.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 unlit;
layout(location = 1) out vec4 direct;
layout(location = 2) out vec4 position;  // world; w as in receivers.glsl: 1 before the light, 0 in the dark, -1 no surface
layout(location = 3) out vec4 height;    // as in receivers.glsl; w: facet normal · light.forward

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    vec3 color = base.rgb * material.baseColor;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    unlit = vec4(ambientAndEmissive(color), 1.0);
    direct = vec4(directLight(color, worldPosition, vertexNormal, facet), 1.0);

    vec3 toLight = light.center - worldPosition;
    vec3 lightHeight = vec3(dot(facet, toLight), light.width * dot(facet, light.right), light.width * dot(facet, light.up));
    bool reached = dot(-toLight, light.forward) > 0.0 && length(toLight) * light.inverseRange < 1.0 &&
                   lightHeight.x + 0.5 * (abs(lightHeight.y) + abs(lightHeight.z)) > 0.0;
    position = vec4(worldPosition, reached ? 1.0 : 0.0);
    height = vec4(lightHeight, dot(facet, light.forward));
}
