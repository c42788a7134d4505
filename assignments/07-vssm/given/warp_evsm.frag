#include "variance_shadow.glsl"
#include "exponential.glsl"

layout(location = 0) out vec4 warped;

void main() {
    float depth = texelFetch(shadowMap, ivec2(gl_FragCoord.xy), 0).r;
    warped = warpedMoments(depth, limitedExponent(shadow.exponent, true));
}
