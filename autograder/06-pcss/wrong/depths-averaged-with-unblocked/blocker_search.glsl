// Fails: Task4BlockerSearch.OnlyBlockersEnterTheMean, Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · every sample's depth enters the mean, not the blockers' alone
#include "soft_shadow.glsl"

struct Blockers {
    float share;
    float depth;
};

Blockers findBlockers(Receiver receiver, vec2 widthUv) {
    float inverse = 1.0 / float(soft.searchSamples), count = 0.0, sum = 0.0;
    for (int j = 0; j < soft.searchSamples; ++j)
        for (int i = 0; i < soft.searchSamples; ++i) {
            vec2 uv = receiver.uvDepth.xy + kernelPoint(vec2(i, j), inverse) * widthUv;
            float depth = storedDepth(uv);
            count += blocks(receiver, uv, depth) ? 1.0 : 0.0;
            sum += depth;
        }
    return Blockers(count * inverse * inverse, count > 0.0 ? sum * inverse * inverse : 0.0);
}
