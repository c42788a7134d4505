// What the light's map knows, and your dials. Twin: SoftShadowBlock in soft_shadow.h.
#include "area_shadow_map.glsl"

layout(std140) uniform SoftShadow {
    vec2 filterWidthUv;     // of plain PCF, where no blocker is searched                    [uv]
    int searchSamples;      // along each side of the blocker search
    int filterSamples;      // along each side of the filter
    float minTexelUv;       // of minDepth
} soft;

// A point of a surface as the light's map sees it.
struct Receiver {
    vec3 uvDepth;      // u, v, depth: [0,1]³ inside the map
    vec3 lightHeight;  // of the light's point (s, t) over the receiver's plane: x + s y + t z, s, t in [-1/2, 1/2]
    vec3 plane;        // over that plane lies a point that is `offset` away in (u, v, depth) iff dot(plane, offset) > 0
    float bias;        // constant bias here [depth]
};

uniform sampler2D minDepth;   // the smallest of shadowMap's depths in the widest search window

// Chunks behind these signatures are linked in, as the settings say.
bool blocks(Receiver receiver, vec2 uv, float depth);    // receiver_plane: does the texel at uv, of that depth, block?
bool aboveHorizon(Receiver receiver, vec2 lightPoint);   // horizon: is the light's point (s, t) over the receiver's plane?
vec2 kernelPoint(vec2 cell, float inverse);             // kernel: sample (i, j) of n x n, in [-1/2, 1/2]²; inverse = 1/n
vec2 searchWindowUv(Receiver receiver);                  // pyramid: full width of the blocker search [uv]
float softVisibility(Receiver receiver);                 // method
