// Fails: Task5Blockers.TheBlockersDepthIsWhatTheMeanLacks, Task5Blockers.TheBlockersDepthLiesBetweenLightAndReceiver, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · what is not blocked is taken to lie at depth 1, not at the receiver's
vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}

float meanBlockerDepth(float depth, float mean, float lit) {
    if (lit > 0.999) return depth;
    return clamp((mean - lit) / (1.0 - lit), 0.0, depth);
}
