// The floor: what a frame costs before anyone asks for shadows.
#include "camera.glsl"
#include "shading.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 color;

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    color = vec4(shade(base.rgb * material.baseColor, worldPosition, vertexNormal, facet, 1.0), 1.0);
}
