// Visibility of one receiver: your chunks in the order in which they are needed.
#include "light.glsl"
#include "shadow_map.glsl"
#include "shadow_coordinates.glsl"
#include "depth_test.glsl"
#include "depth_bias.glsl"
#include "outside_map.glsl"

uniform sampler2D shadowMap;               // depth [0,1], nearest
uniform sampler2DShadow shadowMapCompare;  // the same texels, linear, lit where reference <= depth

// The one texel that holds uv. The plane's depth is taken at that texel's centre: there the stored depth was
// sampled, so a lit plane equals it up to rounding.
float visibilityNearest(vec3 uvDepth, vec2 gradient) {
    vec2 center = (floor(uvDepth.xy / map.texelSizeUv) + 0.5) * map.texelSizeUv;
    float reference = uvDepth.z + dot(gradient, center - uvDepth.xy);
    return litBy(textureLod(shadowMap, center, 0.0).r, reference);
}

// The four texels around uv.
//       2 --- 3        fraction = where uv lies between
//       | *   |        the four texel centres, [0,1]²
//       0 --- 1
float visibility2x2(vec3 uvDepth, vec2 gradient) {
    vec2 texel = uvDepth.xy / map.texelSizeUv - 0.5;
    vec2 fraction = fract(texel);
    vec4 stored = textureGather(shadowMap, (floor(texel) + 1.0) * map.texelSizeUv).wzxy;
    vec2 toFirst = -fraction * map.texelSizeUv;
    vec2 step = gradient * map.texelSizeUv;
    float first = uvDepth.z + dot(gradient, toFirst);
    return filter2x2(stored, first + vec4(0.0, step.x, step.y, step.x + step.y), fraction);
}

// One reference for all four texels, so the plane must be cleared as far as the kernel reaches.
float visibilityHardware2x2(vec3 uvDepth, vec2 gradient) {
    float reference = uvDepth.z - receiverPlaneBias(gradient, map.texelSizeUv, 0.5);
    return textureLod(shadowMapCompare, vec3(uvDepth.xy, reference), 0.0);
}

// receiver: world; facet: unit normal of its triangle's plane on the eye's side.
// Returns the fraction of the point light that the receiver sees, as far as the map knows.
float shadowMapVisibility(vec3 receiver, vec3 facet) {
    vec3 toLight = light.center - receiver;
    float cosTheta = dot(facet, toLight) / length(toLight);
    if (cosTheta <= 0.0) return 0.0;  // attached shadow: no map needed
    vec4 lightClip = lightClipPosition(receiver, map.clipFromWorld);
    float known = visibilityOutsideMap(lightClip);
    if (known != kInsideMap) return known;

    float texelSize = map.texelTangent * lightClip.w;  // w = distance along the light's axis
    vec3 moved = receiver + normalOffset(facet, cosTheta, map.normalOffset, texelSize);
    float towardsLight = constantBias(map.constantBias, texelSize) + slopeBias(map.slopeBias, texelSize, cosTheta);
    moved += towardsLight * normalize(light.center - moved);
    vec3 uvDepth = shadowMapUvDepth(lightClipPosition(moved, map.clipFromWorld));
    uvDepth.z = min(uvDepth.z, 1.0);  // past the far plane nothing is drawn: compare as if on it

    vec2 gradient = vec2(0.0);
    if (map.receiverPlane != 0)
        gradient = receiverPlaneGradient(vec4(facet, -dot(facet, receiver)), map.clipPlaneFromWorldPlane);
    if (map.filterMode == 0) return visibilityNearest(uvDepth, gradient);
    if (map.filterMode == 1) return visibility2x2(uvDepth, gradient);
    return visibilityHardware2x2(uvDepth, gradient);
}
