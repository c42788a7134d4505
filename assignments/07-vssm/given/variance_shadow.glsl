// What the light's map knows, your dials, and the functions that the settings choose. Twin: VarianceShadowBlock in
// variance_shadow.h.
#include "area_shadow_map.glsl"

layout(std140) uniform VarianceShadow {
    vec2 filterWidthUv;     // width=fixed, and image mean_variance                          [uv]
    vec2 leastWidthUv;      // no penumbra is filtered more narrowly                         [uv]
    int queries;            // of the search for blockers: 1, or more in narrower windows
    int searchCells;        // each such window is n x n boxes
    int filterCells;        // and the filter, too
    float center;           // of the depths, subtracted before they are squared             [depth]
    float minVariance;      //                                                               [depth²]
    float lightBleeding;    // share of the bound that is cut off
    float exponent;         // estimate=esm, evsm; already limited
    float integersPerUnit;  // prefilter=sat_cpu_integer, sat_gpu
    float mapSize;          // along each side                                              [texels]
} shadow;

// A point of a surface as the light's map sees it.
struct Receiver {
    vec3 uvDepth;      // u, v, depth: [0,1]³ inside the map
    vec3 lightHeight;  // of the light's point (s, t) over the receiver's plane: x + s y + t z, s, t in [-1/2, 1/2]
    vec2 slope;        // of the receiver's plane in the map: depth per uv
    float bias;        // constant bias here [depth]
};

// A box of the map lies between two upright sides, which its neighbours share.
struct Side {
    vec2 low, high;     // the lower and the upper end [texels], inside the map
    vec2 below, above;  // what the prefilter knows at them
};

// Chunks behind these signatures are linked in, as the settings say.
Side sideAt(vec2 low, vec2 high);                          // prefilter
Side wholeSideAt(vec2 low, vec2 high);                     // prefilter: of ends that lie on corners of texels
vec2 meanBetween(Side left, Side right);                   // prefilter: moments, mean over the box
float litShare(vec2 centerUv, vec2 widthUv, vec2 meanVariance, float depth);  // estimate: share of a box's depths that are not below `depth`
float softVisibility(Receiver receiver);                   // width
