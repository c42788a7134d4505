// Visibility of one receiver: your chunks in the order in which they are needed.
#include "light.glsl"
#include "shadow_map.glsl"
#include "shadow_coordinates.glsl"
#include "depth_bias.glsl"
#include "outside_map.glsl"

// A filter_*.glsl and a bias_*.glsl are linked in with these bodies. Past the far plane nothing is drawn: a filter
// compares as if the receiver, or its plane at the texel's centre, were on it.
float filteredVisibility(vec3 uvDepth, vec2 gradient);
vec4 biasedLightClip(vec4 lightClip, vec3 facet, float cosTheta, float lightDistance);

// lightClip: your light clip position of the receiver, interpolated; facet: unit normal of its triangle's plane
// on the eye's side. Returns the fraction of the point light that the receiver sees, as far as the map knows.
// Without branches: a software rasteriser computes both sides of each.
float shadowMapVisibility(vec3 receiver, vec3 facet, vec4 lightClip) {
    vec3 toLight = towardsLight(receiver);
    float lightDistance = length(toLight);
    float cosTheta = dot(facet, toLight) / lightDistance;
    float known = visibilityOutsideMap(lightClip);

    vec3 unbiased = shadowMapUvDepth(lightClip);
    vec2 gradient = vec2(0.0);
    if (map.receiverPlane != 0) gradient = receiverPlaneGradient(dFdx(unbiased), dFdy(unbiased));
    vec3 uvDepth = shadowMapUvDepth(biasedLightClip(lightClip, facet, cosTheta, lightDistance));
    float visibility = known == kInsideMap ? filteredVisibility(uvDepth, gradient) : known;
    bool reached = cosTheta > 0.0 && lightDistance * light.inverseRange < 1.0;
    return reached ? visibility : 0.0;  // attached shadow, out of range: no map needed
}
