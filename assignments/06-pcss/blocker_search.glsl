#include "soft_shadow.glsl"

struct Blockers {
    float share;  // of all samples: 0 none blocks, 1 all block
    float depth;  // mean of those that block; 0 where none does
};

// Task 4 · what stands in the light's way, at the mean.                                    README §4, [Fernando 2005]
//   widthUv   full width of the search window, may be 0                                    [uv]
// Looks at soft.searchSamples² samples at the receiver's uv plus kernelPoint(vec2(i, j), 1.0 / n) times widthUv.
// Only depths that block enter the mean.
Blockers findBlockers(Receiver receiver, vec2 widthUv) {
    return Blockers(0.0, 0.0);  // yours
}
