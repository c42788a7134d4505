#include "variance_shadow.glsl"
#include "chebyshev.glsl"

float litShare(vec2 centerUv, vec2 widthUv, vec2 meanVariance, float depth) {
    return lessBleeding(chebyshev(depth, meanVariance), shadow.lightBleeding);
}
