// Fails: Task1Penumbra.SearchWindowHoldsABlockerOnTheNearPlane, Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task9Backprojection.AHalfPlaneHidesALinearShare, Task9Backprojection.FenceAndStairsAgreeWithRays · the search window reaches half as far as it must
vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) { return 0.5 * widthScaleUv * max(receiverDepth, 0.0); }

vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}
