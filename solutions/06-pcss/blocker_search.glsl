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
            float blocker = blocks(receiver, uv, depth) ? 1.0 : 0.0;
            count += blocker;
            sum += blocker * depth;
        }
    return Blockers(count / float(soft.searchSamples * soft.searchSamples), count > 0.0 ? sum / count : 0.0);
}
