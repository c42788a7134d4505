// Fails: Task4SoftShadow.ARefinementLooksThroughTheFirstBlockers · refinements compare below the receiver's plane
#include "moment_shadow.glsl"
#include "window.glsl"
#include "quantize.glsl"

// Depths as the map holds them, in and out.
Blockers blockersAmong(vec4 moments, float depth) {
    Blockers blockers = blockersBefore(biasedMoments(moments, soft.momentBias), 2.0 * depth - 1.0);
    return Blockers(blockers.share, 0.5 * blockers.depth + 0.5);
}

Blockers findBlockers(Receiver receiver) {
    Blockers blockers = Blockers(0.0, 0.0);
    for (int i = 0; i <= soft.refinements; ++i) {
        vec4 moments = meanMomentsAround(windowUv(receiver, blockers.depth));
        blockers = blockersAmong(moments, (i == 0 ? receiver.uvDepth.z - receiver.bias : comparedWith(receiver, blockers.depth)));
        if (blockers.share < kLeastShare) return Blockers(0.0, 0.0);
    }
    return blockers;
}

float momentVisibility(Receiver receiver) {
    Blockers blockers = findBlockers(receiver);
    if (blockers.share == 0.0) return receiver.lightShare;
    vec4 light = receiver.light;
    vec2 cell = (light.zw - light.xy) / float(soft.cells);
    float blocked = 0.0;
    for (int j = 0; j < soft.cells; ++j)
        for (int i = 0; i < soft.cells; ++i) {
            receiver.light = light.xyxy + vec4(i, j, i + 1, j + 1) * cell.xyxy;
            vec4 moments = meanMoments(windowUv(receiver, blockers.depth));
            blocked += blockersAmong(moments, comparedWith(receiver, blockers.depth)).share;
        }
    return receiver.lightShare * (1.0 - blocked / float(soft.cells * soft.cells));
}
