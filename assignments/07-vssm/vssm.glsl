#include "windows.glsl"
#include "filter.glsl"
#include "chebyshev.glsl"
#include "penumbra.glsl"

struct Blockers {
    float share;  // of the window: 0 nothing blocks, 1 all does
    float depth;  // their mean; 0 where nothing blocks
};

// Task 6a · blockers in a window around the receiver, cell by cell.                        README §6, [Yang 2010]
//   widthUv   full width of the window                                                     [uv]
// Walks over shadow.searchCells² cells as filter.glsl does, but of wholeTexelsAround(), side by wholeSideOf(): see
// windows.glsl. In each, at its cellMiddle() times widthUv: what does chebyshev() leave lit of what is not nearer than
// blockedBelow(), and at which mean depth is the rest? Returns the mean share, and the mean depth weighted by each cell's
// share.
Blockers blockersInWindow(Receiver receiver, vec2 widthUv) {
    return Blockers(0.0, 0.0);  // yours
}

// Task 6b · the search: first where blockers can be at all, then in a narrower window.     README §6
// shadow.queries windows in all. The first is as wide as the light seen through the map's whole depth before the receiver
// (S is map.widthScaleUv); each of the others is 1.5 times as wide as the penumbra of what the one before has found, and
// not wider than before. None is narrower than shadow.leastWidthUv. A window without blockers ends the search.
Blockers findBlockers(Receiver receiver) {
    return blockersInWindow(receiver, shadow.leastWidthUv);  // yours
}

// Task 6c · variance soft shadows.                                                         README §6, [Yang 2010]
// Returns the receiver's visibility. Where nothing blocks: the share of the light above the horizon, as if the light
// were one cell. Else visibilityInWindow() of the penumbra's width, and of shadow.leastWidthUv at least.
float vssmVisibility(Receiver receiver) {
    return 1.0;  // yours
}
