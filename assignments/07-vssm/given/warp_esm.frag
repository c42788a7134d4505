#include "variance_shadow.glsl"
#include "exponential.glsl"

layout(location = 0) out vec4 warped;

// One channel is all that is looked at, and the others' squares would overflow.
void main() {
    float depth = texelFetch(shadowMap, ivec2(gl_FragCoord.xy), 0).r;
    warped = vec4(warpedMoments(depth, limitedExponent(shadow.exponent, false)).x, 0.0, 0.0, 0.0);
}
