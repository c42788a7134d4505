#include "moment_shadow.glsl"
#include "window.glsl"
#include "quantize.glsl"

float comparedDepth(Receiver receiver, float blockerDepth) {
    vec2 slope = receiver.lightHeight.yz, down = mix(receiver.light.xy, receiver.light.zw, lessThan(slope, vec2(0.0)));
    float fall = clamp(-dot(slope, down) / max(receiver.lightHeight.x, 1e-6), 0.0, 0.9);
    if (receiver.lightHeight.x <= 0.0) fall = 0.0;
    return receiver.uvDepth.z - receiver.bias - fall * max(receiver.uvDepth.z - blockerDepth, 0.0);
}

Blockers blockersInWindow(Receiver receiver, float windowDepth, float planeDepth) {
    vec4 moments = biasedMoments(meanMoments(windowUv(receiver, windowDepth)), soft.momentBias);
    Blockers blockers = blockersBefore(moments, 2.0 * comparedWith(receiver, planeDepth) - 1.0);
    return Blockers(blockers.share, 0.5 * blockers.depth + 0.5);
}

Blockers findBlockers(Receiver receiver) {
    Blockers blockers = blockersInWindow(receiver, 0.0, receiver.uvDepth.z);
    for (int i = 0; i < soft.refinements; ++i) {
        blockers = blockersInWindow(receiver, blockers.depth, receiver.uvDepth.z);
    }
    return blockers;
}

float momentVisibility(Receiver receiver) {
    Blockers blockers = findBlockers(receiver);
    return receiver.lightShare * (1.0 - blockersInWindow(receiver, blockers.depth, blockers.depth).share);
}
