// Fails: Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.TheFilterAsksTheChosenEstimate, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound · every window is as wide as if the receiver were nearer by its bias
#include "windows.glsl"
#include "filter.glsl"
#include "chebyshev.glsl"
#include "penumbra.glsl"

struct Blockers {
    float share;
    float depth;
};

Blockers blockersInWindow(Receiver receiver, vec2 widthUv) {
    float inverse = 1.0 / float(shadow.searchCells), share = 0.0, sum = 0.0;
    Window window = wholeTexelsAround(receiver.uvDepth.xy, widthUv, inverse);
    for (int j = 0; j < shadow.searchCells; ++j) {
        Side left = wholeSideOf(window, 0, j);
        for (int i = 0; i < shadow.searchCells; ++i) {
            Side right = wholeSideOf(window, i + 1, j);
            vec2 box = meanVarianceBetween(window, left, right);
            float depth = blockedBelow(receiver, cellMiddle(i, j, inverse) * widthUv);
            float lit = chebyshev(depth, box);
            share += 1.0 - lit;
            sum += (1.0 - lit) * meanBlockerDepth(depth, box.x, lit);
            left = right;
        }
    }
    return Blockers(share * inverse * inverse, share > 0.0 ? sum / share : 0.0);
}

Blockers findBlockers(Receiver receiver) {
    vec2 window = map.widthScaleUv * max(receiver.uvDepth.z - receiver.bias, 0.0);
    Blockers blockers = Blockers(0.0, 0.0);
    for (int i = 0; i < shadow.queries; ++i) {
        blockers = blockersInWindow(receiver, max(window, shadow.leastWidthUv));
        if (blockers.share == 0.0) return blockers;
        window = min(window, 1.5 * penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z - receiver.bias, blockers.depth));
    }
    return blockers;
}

float vssmVisibility(Receiver receiver) {
    Blockers blockers = findBlockers(receiver);
    if (blockers.share == 0.0) return shareAboveHorizon(receiver, vec2(0.0), 1.0);
    vec2 width = penumbraWidthUv(map.widthScaleUv, receiver.uvDepth.z - receiver.bias, blockers.depth);
    return visibilityInWindow(receiver, max(width, shadow.leastWidthUv));
}
