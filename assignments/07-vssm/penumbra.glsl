// Task 5a · how wide the light is, seen from the receiver through the blocker's plane.     README §5, [Fernando 2005]
//   widthScaleUv    S: how wide the light is, seen through a depth difference of 1           [uv]
//   receiverDepth, blockerDepth   [0,1]
// Returns full widths along u and v [uv], 0 at contact, and never less.
vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return vec2(0.0);  // yours
}

// Task 5b · mean depth of those that block, from the mean depth of all.                    README §5, [Yang 2010]
//   depth   of the receiver, less its bias: what is nearer blocks
//   mean    of the box's depths
//   lit     share of the box that does not block; its mean depth is taken to be `depth`
// Returns a depth in [0, depth]; `depth` itself where more than 0.999 is lit, since then nothing can be told.
float meanBlockerDepth(float depth, float mean, float lit) {
    return depth;  // yours
}
