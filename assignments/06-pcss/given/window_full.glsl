// pyramid=off: whatever can block at all.
#include "soft_shadow.glsl"
#include "penumbra.glsl"

vec2 searchWindowUv(Receiver receiver) { return searchWidthUv(map.widthScaleUv, receiver.uvDepth.z); }
