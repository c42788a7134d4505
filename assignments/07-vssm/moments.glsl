// Task 1 · what of a texel is worth averaging.                                             README §1, [Donnelly 2006]
//   depth    of one texel of the shadow map, [0,1]
//   center   a depth that all texels share, about the middle of the map's depths
// Returns the first two moments about the centre: how far the depth lies beyond it, and the square of that.
vec2 momentsFromDepth(float depth, float center) {
    return vec2(0.0);  // yours
}
