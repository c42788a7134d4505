// Multiplies the visibility of what it covers: direct light alone is dimmed, whatever the surface's colour.
#include "planar.glsl"

in vec2 surfaceUv;
layout(location = 0) out float visibility;

bool isMissing(vec2 uv);  // opaque.glsl or masked.glsl

void main() {
    if (isMissing(surfaceUv)) discard;
    visibility = planar.shadowVisibility;
}
