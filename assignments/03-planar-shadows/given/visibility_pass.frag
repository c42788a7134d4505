// What a surface sees of the light before any flattened caster is drawn: attached shadow, and the shadow texture's.
#include "camera.glsl"
#include "light.glsl"
#include "shading.glsl"

in vec3 worldPosition;
in vec2 surfaceUv;
layout(location = 0) out float visibility;
layout(location = 1) out float receiver;

uniform float isReceiver;

bool isMissing(vec2 uv);                     // opaque.glsl or masked.glsl
float castVisibility(vec3 worldPosition);  // texture_off.glsl or texture_on.glsl

// The light is above the facet, before its own plane and within its range.
bool isFacingLight(vec3 p, vec3 facet) {
    vec3 toLight = towardsLight(p);
    bool beforeLight = light.position.w == 0.0 || dot(toLight, light.forward) < 0.0;
    return dot(facet, toLight) > 0.0 && beforeLight && lightFalloff(length(toLight)) > 0.0;
}

void main() {
    if (isMissing(surfaceUv)) discard;
    bool facing = isFacingLight(worldPosition, facetNormal(worldPosition, camera.eye));
    visibility = facing ? castVisibility(worldPosition) : 0.0;
    receiver = isReceiver;
}
