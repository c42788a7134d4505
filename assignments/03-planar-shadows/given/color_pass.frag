// Colour, from the visibility that the passes before have left at this pixel.
#include "camera.glsl"
#include "shading.glsl"

in vec3 worldPosition;
in vec3 vertexNormal;
in vec2 surfaceUv;
layout(location = 0) out vec4 color;

uniform sampler2D visibilityImage;

void main() {
    vec4 base = baseColorSample(surfaceUv);
    if (base.a < material.alphaCutoff) discard;
    float visibility = texelFetch(visibilityImage, ivec2(gl_FragCoord.xy), 0).r;
    vec3 facet = facetNormal(worldPosition, camera.eye);
    color = vec4(shade(base.rgb * material.baseColor, worldPosition, vertexNormal, facet, visibility), 1.0);
}
