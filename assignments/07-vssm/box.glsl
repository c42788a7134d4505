// A corner (x, y) is counted in texels from the map's lower left: (0, 0) there, the map's size at the upper right, and
// anything between. The table's value at it, F(x, y), is the sum of all moments left of x and below y.

// Task 3a · where in the texture is F(x, y)?                                               README §3
//   corner        (x, y)                                                                   [texels]
//   texelSizeUv   1 / size of the map
// Returns uv. Texel (i, j) of the table, whose centre is (i + 1/2, j + 1/2), holds the sum over texels 0 … i and 0 … j,
// itself included; the texture is filtered linearly and is 0 beyond its lower and left border.
vec2 tableUv(vec2 corner, vec2 texelSizeUv) {
    return vec2(0.0);  // yours
}

// Task 3b · the sum over a box.                                                            README §3, [Crow 1984]
//   lowLow …   the table at the corners (low x, low y), (high x, low y), (low x, high y), (high x, high y)
vec2 boxSum(vec2 lowLow, vec2 highLow, vec2 lowHigh, vec2 highHigh) {
    return vec2(0.0);  // yours
}

// Task 3c · a box that reaches beyond the map.                                             README §3
//   meanInside    mean moments of its part inside
//   shareInside   of its area, 0 … 1
//   center        as in Task 1
// Returns the mean moments of the whole box. Beyond the map nothing blocks: depth 1 there.
vec2 withBorder(vec2 meanInside, float shareInside, float center) {
    return meanInside;  // yours
}

// Task 3d · mean and variance.                                                             README §3
//   moments       mean moments about the centre
//   minVariance   >= 0                                                                     [depth²]
// Returns the mean depth, centre and all, and the variance, never below minVariance.
vec2 meanVariance(vec2 moments, float center, float minVariance) {
    return vec2(1.0, minVariance);  // yours; as if the box were empty
}
