#include "soft_shadow.glsl"

// Share of the square [-1/2, 1/2]² where height.x + s height.y + t height.z > 0: a ramp, integrated twice. Where the
// horizon cuts the square, the steeper slope is not small beside height.x; the other may be 0.
float shareAboveHorizon(vec3 height) {
    vec2 slope = abs(height.yz);
    float reach = 0.5 * (slope.x + slope.y);
    if (abs(height.x) >= reach) return height.x > 0.0 ? 1.0 : 0.0;
    slope = max(slope, 1e-3 * max(slope.x, slope.y));
    vec4 ramp = max(height.x + 0.5 * vec4(slope.x + slope.y, slope.y - slope.x, slope.x - slope.y, -slope.x - slope.y), 0.0);
    ramp *= ramp;
    return clamp((ramp.x - ramp.y - ramp.z + ramp.w) / (2.0 * slope.x * slope.y), 0.0, 1.0);
}

float backprojectedVisibility(Receiver receiver) {
    vec2 window = searchWindowUv(receiver);
    float lit = shareAboveHorizon(receiver.lightHeight);
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
            lit -= aboveHorizon(receiver, 0.5 * (low + high)) ? (high.x - low.x) * (high.y - low.y) : 0.0;
        }
    return clamp(lit, 0.0, 1.0);
}
