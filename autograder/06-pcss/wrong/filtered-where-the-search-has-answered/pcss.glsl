// Fails: Task5Pcss.FiltersAsTheSearchSays · no early answer where nothing or everything blocks: the filter is asked there, too
#include "soft_shadow.glsl"
#include "penumbra.glsl"
#include "blocker_search.glsl"
#include "pcf.glsl"

float pcssVisibility(Receiver receiver) {
    vec2 window = searchWindowUv(receiver);
    Blockers blockers = findBlockers(receiver, window);
    float depth = blockers.share > 0.0 ? blockers.depth : receiver.uvDepth.z;
    return percentageCloser(receiver, max(penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z, depth), map.texelSizeUv));
}
