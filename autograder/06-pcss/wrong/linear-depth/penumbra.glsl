// Fails: Task1Penumbra.PenumbraFollowsSimilarTriangles, Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · the lecture's formula for distances, fed with depth-buffer values
vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) { return widthScaleUv * max(receiverDepth, 0.0); }

vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0) / max(blockerDepth, 1e-3);
}
