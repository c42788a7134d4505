// Intermediate results as images, for you and for the grader.
#include "material.glsl"
#include "shadow_coordinates.glsl"

in vec2 surfaceUv;
in vec4 lightClip;
layout(location = 0) out vec4 shadowCoordinates;  // u, v, depth, and lightClip.w

void main() {
    if (isHole(surfaceUv)) discard;
    // In the plane of the light there are no coordinates; an image holds finite numbers only.
    shadowCoordinates = lightClip.w == 0.0 ? vec4(0.0) : vec4(shadowMapUvDepth(lightClip), lightClip.w);
}
