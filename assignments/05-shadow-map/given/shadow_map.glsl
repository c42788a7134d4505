// The shadow map's view and your dials. Twin: ShadowMapBlock in assignment.cpp.
layout(std140) uniform ShadowMap {
    mat4 clipFromWorld;     // light clip space
    vec4 lightCenterClip;   // where the light itself lands in it: w = 0
    vec2 texelSizeUv;       // 1 / map size
    float texelTangent;     // width of one texel at distance 1 along the light's axis
    float depthResolution;  // smallest step of the depth format at depth 1
    float constantBias;     // [texels]
    float slopeBias;        // [texels]
    float normalOffset;     // [texels]
    int receiverPlane;      // 0 off, 1 on
} map;

// What no bias of yours has to pay for: the map's depth and the receiver's come from different arithmetic, a few
// units in the last place of a float apart, and the plane's gradient from differences across one pixel. At 89 degrees
// v changes by 2e-5 a pixel and is rounded to 6e-8: three such differences are good to 2 %.
float depthRounding(vec2 gradient) {
    return map.depthResolution + 1e-6 + 0.02 * dot(abs(gradient), map.texelSizeUv);
}
