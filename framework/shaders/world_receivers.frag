// What the camera sees, before any shadow, in world space: for techniques whose light is no single map.
#include "camera.glsl"
#include "shading.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 unlit;     // ambient and emitted light: no shadow touches it
layout(location = 1) out vec4 direct;    // the light's own, to be multiplied by visibility
layout(location = 2) out vec4 position;  // world; w: 1 a surface before the light, 0 one in the dark, -1 none
layout(location = 3) out vec4 normal;    // the facet's, unit, on the eye's side

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    vec3 color = base.rgb * material.baseColor;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    unlit = vec4(ambientAndEmissive(color), 1.0);
    direct = vec4(directLight(color, worldPosition, vertexNormal, facet), 1.0);

    vec3 toLight = light.center - worldPosition;
    float reach = 0.5 * light.width * (abs(dot(facet, light.right)) + abs(dot(facet, light.up)));
    bool reached = dot(toLight, light.forward) < 0.0 && length(toLight) * light.inverseRange < 1.0 &&
                   dot(facet, toLight) + reach > 0.0;
    position = vec4(worldPosition, reached ? 1.0 : 0.0);
    normal = vec4(facet, 0.0);
}
