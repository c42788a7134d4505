// Fails: Task9Backprojection.FenceAndStairsAgreeWithRays, Task9Backprojection.TheHorizonIsAClosedForm · backprojection starts from the whole light, whatever the horizon
#include "soft_shadow.glsl"

float backprojectedVisibility(Receiver receiver) {
    vec2 window = searchWindowUv(receiver);
    float lit = 1.0;
    if (window.x <= 0.0) return lit;
    vec2 cell = max(window / float(soft.filterSamples), map.texelSizeUv);
    vec2 first = receiver.uvDepth.xy - 0.5 * cell * float(soft.filterSamples - 1);
    for (int j = 0; j < soft.filterSamples; ++j)
        for (int i = 0; i < soft.filterSamples; ++i) {
            vec2 uv = first + vec2(i, j) * cell;
            float depth = storedDepth(uv);
            if (!blocks(receiver, uv, depth)) continue;
            vec2 scale = 1.0 / (map.widthScaleUv * (receiver.uvDepth.z - depth));
            vec2 center = (uv - receiver.uvDepth.xy) * scale, halfSize = 0.5 * cell * scale;
            vec2 low = clamp(center - halfSize, -0.5, 0.5), high = clamp(center + halfSize, -0.5, 0.5);
            lit -= (high.x - low.x) * (high.y - low.y);
        }
    return max(lit, 0.0);
}
