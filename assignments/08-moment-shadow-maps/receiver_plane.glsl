#include "moment_shadow.glsl"

// Task 4a · which depth to compare with.                                                   README §4
//   receiver       the plane around it is given by lightHeight: the light's point p = (s, t) stands h + k·p over it,
//                  h = lightHeight.x, k = lightHeight.yz
//   blockerDepth   the filter looks at depths there: the ray to p passes it S (receiver's depth - blockerDepth) p away
// Within the filter, the receiver's plane reaches up towards the light: at p it is nearer than the receiver by
// fall(p) = -k·p / h, in units of (receiver's depth - blockerDepth). Let fall be its greatest value for p in the rectangle
// receiver.light (low s, low t, high s, high t), and keep it within [0,1]; 1 where h ≤ 0 and some fall is > 0.
// Returns receiver's depth - bias - 3/4 fall (receiver's depth - blockerDepth); a blockerDepth beyond the receiver counts
// as the receiver's.
float comparedDepth(Receiver receiver, float blockerDepth) {
    return receiver.uvDepth.z - receiver.bias;  // yours; the constant bias alone
}
