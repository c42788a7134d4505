// What no shadow touches; depth for all passes that follow.
#include "camera.glsl"
#include "lighting.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 color;
layout(location = 1) out float visibility;

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    color = vec4(firstPass(base.rgb * material.baseColor, worldPosition, vertexNormal, facet), 1.0);
    visibility = 0.0;
}
