// Fails: Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task5Pcss.FiltersAsTheSearchSays, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · dark where half of the search blocks
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
    if (blockers.share > 0.5) return 0.0;
    float depth = blockers.share > 0.0 ? blockers.depth : receiver.uvDepth.z;
    return percentageCloser(receiver, max(penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z, depth), map.texelSizeUv));
}
