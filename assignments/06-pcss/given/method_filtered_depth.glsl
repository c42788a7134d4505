// The classic error: the depths are averaged, and the mean is compared. Between a near blocker and a far ground
// there is no surface, so this answers 0 or 1 about nothing.
#include "soft_shadow.glsl"

float softVisibility(Receiver receiver) {
    float inverse = 1.0 / float(soft.filterSamples), sum = 0.0;
    for (int j = 0; j < soft.filterSamples; ++j)
        for (int i = 0; i < soft.filterSamples; ++i)
            sum += storedDepth(receiver.uvDepth.xy + kernelPoint(vec2(i, j), inverse) * soft.filterWidthUv);
    return blocks(receiver, receiver.uvDepth.xy, sum * inverse * inverse) ? 0.0 : 1.0;
}
