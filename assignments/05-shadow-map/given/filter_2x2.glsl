// Your filter2x2() on the four texels around uv, each compared with the plane's depth at its own centre.
//       2 --- 3        fraction = where uv lies between
//       | *   |        the four texel centres, [0,1]²
//       0 --- 1
#include "depth_test.glsl"
#include "shadow_map.glsl"

uniform sampler2D shadowMap;  // depth [0,1], nearest

float filteredVisibility(vec3 uvDepth, vec2 gradient) {
    vec2 texel = uvDepth.xy / map.texelSizeUv - 0.5;
    vec2 fraction = fract(texel);
    vec4 stored = textureGather(shadowMap, (floor(texel) + 1.0) * map.texelSizeUv).wzxy;
    vec2 step = gradient * map.texelSizeUv;
    float first = uvDepth.z - dot(step, fraction) - depthRounding(gradient);
    vec4 references = first + vec4(0.0, step.x, step.y, step.x + step.y);
    return filter2x2(stored, min(references, 1.0), fraction);
}
