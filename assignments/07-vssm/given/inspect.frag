// Intermediate results as images, for you and for the grader. 0 where there is no receiver before the light.
#include "receiver_visibility.glsl"
#include "vssm.glsl"

// Depth in [0,1]; width in units of S, the light seen through the whole depth range, so that both run from 0 to 1.
layout(location = 0) out float blockerDepth;
layout(location = 1) out float penumbraWidth;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    blockerDepth = 0.0, penumbraWidth = 0.0;
    if (texelFetch(receiverPosition, pixel, 0).w <= 0.0) return;
    Receiver receiver = receiverAt(pixel);
    Blockers blockers = findBlockers(receiver);
    if (blockers.share <= 0.0 || receiver.lightHeight.x <= 0.0) return;
    blockerDepth = blockers.depth;
    penumbraWidth = penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z, blockers.depth).x / map.widthScaleUv.x;
}
