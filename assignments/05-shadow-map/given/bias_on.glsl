// Your three moves of the receiver, made in light clip space, where they are as linear as in the world: an offset
// adds its own projection, and a step towards the light is a mix with the light's own clip position.
#include "depth_bias.glsl"
#include "shadow_map.glsl"

vec4 biasedLightClip(vec4 lightClip, vec3 facet, float cosTheta, float lightDistance) {
    float texelSize = map.texelTangent * lightClip.w;  // w = distance along the light's axis
    float cosine = clamp(cosTheta, 1e-6, 1.0);
    vec3 offset = normalOffset(facet, cosine, map.normalOffset, texelSize);
    float towardsLight = constantBias(map.constantBias, texelSize) + slopeBias(map.slopeBias, texelSize, cosine);
    vec4 moved = lightClip + map.clipFromWorld * vec4(offset, 0.0);
    return mix(moved, map.lightCenterClip, min(towardsLight / lightDistance, 0.5));
}
