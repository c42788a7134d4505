// Fails: Task1Penumbra.PenumbraFollowsSimilarTriangles, Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · the penumbra's width is taken for its radius
vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) { return widthScaleUv * max(receiverDepth, 0.0); }

vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return 2.0 * widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}
