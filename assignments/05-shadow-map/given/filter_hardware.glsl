// The hardware's 2x2: one reference for all four texels, so the plane must be cleared as far as the kernel reaches,
// half a texel beyond the one that holds uv.
#include "depth_bias.glsl"
#include "shadow_map.glsl"

uniform sampler2DShadow shadowMapCompare;  // linear, lit where reference <= depth

float filteredVisibility(vec3 uvDepth, vec2 gradient) {
    float reference = uvDepth.z - receiverPlaneBias(gradient, map.texelSizeUv, 0.5) - depthRounding(gradient);
    return textureLod(shadowMapCompare, vec3(uvDepth.xy, min(reference, 1.0)), 0.0);
}
