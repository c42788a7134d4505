// Intermediate results as images, for you and for the grader. 0 where there is no receiver before the light.
#include "receiver.glsl"
#include "msm.glsl"

layout(location = 0) out float blockerDepth;   // mean, 0 where none
layout(location = 1) out float blockerShare;
layout(location = 2) out float penumbraWidth;  // in units of S, the light seen through the whole depth range; 0 where none
layout(location = 3) out vec4 boxMoments;      // mean over the texels of the first search window

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    blockerDepth = 0.0, blockerShare = 0.0, penumbraWidth = 0.0, boxMoments = vec4(0.0);
    if (texelFetch(receiverPosition, pixel, 0).w <= 0.0) return;
    Receiver receiver = receiverAt(pixel);
    boxMoments = meanMomentsAround(windowUv(receiver, 0.0));
    Blockers blockers = findBlockers(receiver);
    blockerShare = blockers.share;
    if (blockers.share <= 0.0) return;
    blockerDepth = blockers.depth;
    penumbraWidth = max(receiver.uvDepth.z - blockers.depth, 0.0);
}
