// pyramid=on: whatever can block, given the nearest depth around.
#include "soft_shadow.glsl"
#include "penumbra.glsl"
#include "min_pyramid.glsl"

vec2 searchWindowUv(Receiver receiver) {
    vec2 full = searchWidthUv(map.widthScaleUv, receiver.uvDepth.z);
    float nearest = textureLod(minDepth, receiver.uvDepth.xy, 0.0).r;
    return narrowedWidthUv(full, map.widthScaleUv, receiver.uvDepth.z, nearest);
}
