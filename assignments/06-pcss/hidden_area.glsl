#include "soft_shadow.glsl"

// Bonus · every texel of the search window, seen from the receiver, hides a rectangle of the light.
//                                                                                          README §9, [Guennebaud 2006]
// Returns the receiver's visibility: the share of the light above the horizon, less what the window's blockers hide
// above it, within [0, 1]. Divide searchWindowUv(receiver) into soft.filterSamples² cells, none narrower than a texel,
// and let the depth at each cell's centre stand for the cell.
float backprojectedVisibility(Receiver receiver) {
    return 1.0;  // yours
}
