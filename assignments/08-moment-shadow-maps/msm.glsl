#include "moment_shadow.glsl"
#include "window.glsl"
#include "quantize.glsl"

// Task 4b · what stands in the light's way, at the mean.                                   README §4, [Peters et al. 2017]
// Looks at meanMomentsAround(windowUv(receiver, depth)), first with depth 0, then soft.refinements times with the depth
// just found. Biased by soft.momentBias, blockersBefore() knows share and mean depth of what is nearer than
// comparedWith(receiver, receiver's own depth). Mind that it counts depths from -1 to 1.
// Returns the last answer, depth in [0,1]; share 0 and depth 0 as soon as an answer's share is below kLeastShare.
Blockers findBlockers(Receiver receiver) {
    return Blockers(0.0, 0.0);  // yours
}

// Task 4c · soft shadows.                                                                  README §4, [Peters et al. 2017]
// Returns the receiver's visibility: of receiver.lightShare, what is left by the blockers in the filter. The filter is
// windowUv() of their mean depth, compared with comparedWith(receiver, their mean depth). It is cut into soft.cells ×
// soft.cells equal parts, each with its own meanMoments() and its own answer: a part's window and
// compared depth are those of a receiver whose `light` is the part's rectangle. Without blockers all of
// receiver.lightShare is left.
float momentVisibility(Receiver receiver) {
    return 1.0;  // yours
}
