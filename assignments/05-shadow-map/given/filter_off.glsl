// The one texel that holds uv. The plane's depth is taken at that texel's centre: there the stored depth was
// sampled, so a lit plane equals it up to rounding.
#include "depth_test.glsl"
#include "shadow_map.glsl"

uniform sampler2D shadowMap;  // depth [0,1], nearest

float filteredVisibility(vec3 uvDepth, vec2 gradient) {
    vec2 center = (floor(uvDepth.xy / map.texelSizeUv) + 0.5) * map.texelSizeUv;
    float reference = uvDepth.z + dot(gradient, center - uvDepth.xy) - depthRounding(gradient);
    return litBy(textureLod(shadowMap, center, 0.0).r, min(reference, 1.0));
}
