#include "soft_shadow.glsl"
#include "penumbra.glsl"
#include "blocker_search.glsl"
#include "pcf.glsl"

// Task 5 · percentage-closer soft shadows: search, estimate, filter.                       README §5, [Fernando 2005]
// Returns the receiver's visibility. The search window is searchWindowUv(receiver). The filter is as wide as the
// penumbra, and never narrower than a texel: S is map.widthScaleUv, a texel map.texelSizeUv. Without any filter, since
// most receivers need none:
//   1 where nothing blocks and the whole light is above the receiver's horizon (ask for its lowest corner)
//   0 where every sample of the search blocks
// Where nothing blocks but part of the light is below the horizon, the narrowest filter counts that part.
float pcssVisibility(Receiver receiver) {
    return 1.0;  // yours
}
