// Fails: Task5Blockers.PenumbraFollowsSimilarTriangles, Task6SoftShadows.AHalfPlanesPenumbraIsALinearRamp, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.TheFilterAsksTheChosenEstimate, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound, Task8WholeShadow.FenceAgreesWithRays · half the penumbra's width is taken for its width
vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return 0.5 * widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}

float meanBlockerDepth(float depth, float mean, float lit) {
    if (lit > 0.999) return depth;
    return clamp((mean - lit * depth) / (1.0 - lit), 0.0, depth);
}
