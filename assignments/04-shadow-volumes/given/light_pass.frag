// One light's own share, where stencil and depth let it through. Holes need no test: there the depth is another's.
#include "camera.glsl"
#include "lighting.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 color;
layout(location = 1) out float visibility;

void main() {
    vec3 base = baseColorSample(surfaceUv).rgb * material.baseColor;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    color = vec4(lightPass(base, worldPosition, vertexNormal, facet), 1.0);
    visibility = reachesReceiver(worldPosition, facet);
}
