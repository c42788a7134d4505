// A shadow map of an area light, seen from its centre. Twin: ShadowMapBlock in render/area_shadow_map.h.
layout(std140) uniform ShadowMap {
    mat4 clipFromWorld;     // light clip space
    vec2 texelSizeUv;       // 1 / map size
    vec2 widthScaleUv;      // S: how wide the light is, seen through a depth difference of 1 [uv]
    float biasAtZero;       // constant bias [depth]: biasAtZero + biasSlope * depth, so many
    float biasSlope;        // texels in the world at any distance
} map;

uniform sampler2D shadowMap;  // depth [0,1], nearest texel; 1 beyond the border

// Depth of the texel that holds uv.
float storedDepth(vec2 uv) { return textureLod(shadowMap, uv, 0.0).r; }

vec2 texelCenter(vec2 uv) { return (floor(uv / map.texelSizeUv) + 0.5) * map.texelSizeUv; }

float constantBias(float depth) { return map.biasAtZero + map.biasSlope * depth; }
