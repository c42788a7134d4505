// Where a ray comes nearest to a blocker, that blocker's edge draws a line across the light.
#include "receiver.glsl"
#include "edge.glsl"
#include "light_share.glsl"

const float kCorner = 1.4142136;   // the light's corners are so much farther from its centre than its edges
const float kAcross = 0.7;         // see trusted

struct EdgeLine {
    vec3 height;    // the light's point (s, t) is on the visible side iff x + s y + t z > 0
    bool near;      // there is such a line: the ray came near an edge, or went deep
    bool trusted;   // it is an edge's, not a sheet's: inside a thin blocker distance says how thin it is, nothing of its edge
};

EdgeLine edgeLine(Receiver receiver, vec3 direction, Approach nearest, float highest, float lowest) {
    if (nearest.ratio >= highest) return EdgeLine(vec3(1.0, 0.0, 0.0), false, true);
    if (nearest.ratio <= lowest) return EdgeLine(vec3(-1.0, 0.0, 0.0), true, true);
    vec3 slope = gradient(receiver.origin + nearest.t * direction, 0.5 * field.cell);
    vec3 plane = edgePlane(safeTangent(nearest.ratio), direction, slope);
    vec3 height = vec3(dot(plane, light.center - receiver.origin), light.width * dot(plane, light.right),
                       light.width * dot(plane, light.up));
    bool thin = length(slope - dot(slope, direction) * direction) < kAcross;
    return EdgeLine(height, true, nearest.ratio > 0.0 || !thin);
}

// The whole light, corners too, is lit or dark beyond these ratios.
float surelyLit(Receiver receiver) { return kCorner * receiver.edgeRatio; }
