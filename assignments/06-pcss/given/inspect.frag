// Intermediate results as images, for you and for the grader. 0 where there is no receiver before the light.
#include "receiver.glsl"
#include "blocker_search.glsl"
#include "penumbra.glsl"

layout(location = 0) out float blockerDepth;  // mean, 0 where none
layout(location = 1) out float penumbraTexels;
layout(location = 2) out vec4 searched;  // width of the search window [texels, u v], share of blockers, receiver's depth

void main() {
    float kind;
    Receiver receiver = receiverAt(ivec2(gl_FragCoord.xy), kind);
    blockerDepth = 0.0, penumbraTexels = 0.0, searched = vec4(0.0);
    if (kind <= 0.0) return;
    vec2 window = searchWindowUv(receiver);
    Blockers blockers = findBlockers(receiver, window);
    blockerDepth = blockers.share > 0.0 ? blockers.depth : 0.0;
    if (blockers.share > 0.0)
        penumbraTexels = penumbraWidthUv(soft.widthScaleUv, receiver.uvDepth.z, blockers.depth).x / soft.texelSizeUv.x;
    searched = vec4(window / soft.texelSizeUv, blockers.share, receiver.uvDepth.z);
}
