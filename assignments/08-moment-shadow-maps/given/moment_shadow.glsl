// What the light's map and its moments know, and your dials. Twin: MomentShadowBlock in moment_shadow.h.
//
// Depths d of the map are in [0,1]; moments are of z = 2 d - 1, in [-1,1]: b = (E[z], E[z²], E[z³], E[z⁴]).
#include "area_shadow_map.glsl"

layout(std140) uniform MomentShadow {
    vec2 filterWidthUv;     // filter=fixed: width of the box                                [uv]
    float momentBias;       // of biasedMoments()
    int refinements;        // of the search window
    int cells;              // along each side of the filter's box
    float unitsPerInteger;  // prefilter=sat_cpu_integer: what 1 in the table stands for
} soft;

const float kLeastShare = 0.001;  // fewer blockers than that are none: what rounding and the moment bias leave

// A point of a surface as the light's map sees it.
struct Receiver {
    vec3 uvDepth;      // u, v, depth: [0,1]³ inside the map
    vec3 lightHeight;  // of the light's point (s, t) over the receiver's plane: x + s y + t z, s, t in [-1/2, 1/2]
    vec4 light;        // low (s, t), high (s, t): the rectangle that holds what is over the plane; ±1/2 with horizon=off
    float lightShare;  // share of the light over the plane; 1 with horizon=off
    float bias;        // constant bias here [depth]
};

// What is nearer than some depth.
struct Blockers {
    float share;  // of all, [0,1]
    float depth;  // their mean
};

// Chunks behind these signatures are linked in, as the settings say.
vec4 storedMoments(vec4 moments);                // storage: what the texture keeps
vec4 momentsFromStored(vec4 stored);             // storage: back again
vec4 meanStored(vec2 lowUv, vec2 highUv);        // prefilter: mean over a box inside the map that is not empty
vec4 meanStoredAround(vec2 lowUv, vec2 highUv);  // the same over all texels that the box touches
Blockers blockersBefore(vec4 moments, float t);  // method: of z nearer than t, all in [-1,1]
float comparedWith(Receiver receiver, float blockerDepth);  // receiver_plane: comparedDepth(), or the constant bias
float filteredVisibility(Receiver receiver);     // filter
