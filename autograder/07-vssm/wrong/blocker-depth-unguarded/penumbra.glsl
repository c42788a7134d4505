// Fails: Task5Blockers.TheBlockersDepthLiesBetweenLightAndReceiver, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound · the blocker's depth is neither guarded nor clamped
vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}

float meanBlockerDepth(float depth, float mean, float lit) {
    return (mean - lit * depth) / (1.0 - lit);
}
