// Forward pass: colour and visibility of what the camera sees.
#include "camera.glsl"
#include "facing.glsl"
#include "shading.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 color;
layout(location = 1) out float visibility;

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    visibility = facingVisibility(facet, light.center - worldPosition);
    color = vec4(shade(base.rgb * material.baseColor, worldPosition, vertexNormal, facet, visibility), 1.0);
}
