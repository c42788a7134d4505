// Fails: Task5Pcss.FiltersAsTheSearchSays, Task5Pcss.TheHorizonIsCountedOnce · the finished visibility is cut by the horizon once more
#include "soft_shadow.glsl"
#include "penumbra.glsl"
#include "blocker_search.glsl"
#include "pcf.glsl"

float pcssVisibility(Receiver receiver) {
    vec2 window = searchWindowUv(receiver);
    bool wholeLight = aboveHorizon(receiver, -sign(receiver.lightHeight.yz) * 0.5);
    if (window.x <= 0.0 && wholeLight) return 1.0;
    Blockers blockers = findBlockers(receiver, window);
    if (blockers.share == 0.0 && wholeLight) return 1.0;
    if (blockers.share == 1.0) return 0.0;
    float depth = blockers.share > 0.0 ? blockers.depth : receiver.uvDepth.z;
    float centre = clamp(0.5 + receiver.lightHeight.x / dot(abs(receiver.lightHeight.yz), vec2(1.0)), 0.0, 1.0);
    return centre * percentageCloser(receiver, max(penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z, depth), map.texelSizeUv));
}
