// Intermediate results as images, for you and for the grader. 0 where there is no receiver before the light.
#include "receiver.glsl"
#include "blocker_search.glsl"
#include "penumbra.glsl"

// Widths in units of S, the light seen through the whole depth range, so that they run from 0 to 1 as depths do.
layout(location = 0) out float blockerDepth;   // mean, 0 where none
layout(location = 1) out float penumbraWidth;  // 0 where nothing blocks
layout(location = 2) out vec4 searched;        // width of the search window along u and v, share of blockers, receiver's depth

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    blockerDepth = 0.0, penumbraWidth = 0.0, searched = vec4(0.0);
    if (texelFetch(receiverPosition, pixel, 0).w <= 0.0) return;
    Receiver receiver = receiverAt(pixel);
    vec2 window = searchWindowUv(receiver);
    Blockers blockers = findBlockers(receiver, window);
    searched = vec4(window / map.widthScaleUv, blockers.share, receiver.uvDepth.z);
    blockerDepth = blockers.depth;
    if (blockers.share == 0.0) return;
    penumbraWidth = penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z, blockers.depth).x / map.widthScaleUv.x;
}
