// Fails: Task1Moments.DistanceFromTheCenterAndItsSquare, Task1Moments.EveryTexelOfTheMapHasItsOwn, Task6SoftShadows.AHalfPlanesPenumbraIsALinearRamp, Task6SoftShadows.ATinyLightCastsAHardShadowAndAHugeOneStaysFinite, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.ScalingTheWorldChangesNothing, Task6SoftShadows.TheFilterAsksTheChosenEstimate, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · the center is not subtracted
vec2 momentsFromDepth(float depth, float center) {
    float d = depth;
    return vec2(d, d * d);
}
