// Intermediate results as images, for you and for the grader.
#include "material.glsl"
#include "shadow_lookup.glsl"

in vec3 worldPosition;
in vec2 surfaceUv;
layout(location = 0) out vec4 shadowCoordinates;  // u, v, depth, and lightClip.w

void main() {
    if (isHole(surfaceUv)) discard;
    vec4 lightClip = lightClipPosition(worldPosition, map.clipFromWorld);
    shadowCoordinates = vec4(shadowMapUvDepth(lightClip), lightClip.w);
}
