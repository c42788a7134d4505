// What the camera sees, before any shadow: its light, and its place in the light's map.
#include "camera.glsl"
#include "shading.glsl"
#include "area_shadow_map.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
in vec4 lightClip;
layout(location = 0) out vec4 unlit;     // ambient and emitted light: no shadow touches it
layout(location = 1) out vec4 direct;    // the light's own, to be multiplied by visibility
layout(location = 2) out vec4 position;  // see receivers.glsl
layout(location = 3) out vec4 height;

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    vec3 color = base.rgb * material.baseColor;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    unlit = vec4(ambientAndEmissive(color), 1.0);
    direct = vec4(directLight(color, worldPosition, vertexNormal, facet), 1.0);

    vec3 toLight = light.center - worldPosition;
    vec3 lightHeight = vec3(dot(facet, toLight), light.width * dot(facet, light.right), light.width * dot(facet, light.up));
    bool reached = lightClip.w > 0.0 && length(toLight) * light.inverseRange < 1.0 &&
                   lightHeight.x + 0.5 * (abs(lightHeight.y) + abs(lightHeight.z)) > 0.0;
    position = reached ? vec4(0.5 * lightClip.xyz / lightClip.w + 0.5, 1.0) : vec4(0.0);
    height = vec4(lightHeight, 0.0);
}
