// Fails: Task1Moments.DepthsOutsideCountAsTheNearestInside, Task1Moments.EveryTexelHoldsThoseOfItsDepth, Task1Moments.TheyArePowersOfADepthFromMinusOneToOne, Task4SoftShadow.AHalfPlanesPenumbraIsALinearRamp, Task4SoftShadow.ARefinementLooksThroughTheFirstBlockers, Task4SoftShadow.ATinyLightCastsAHardShadowAndAHugeOneStaysFinite, Task4SoftShadow.EachCellIsComparedBelowItsPartOfThePlane, Task4SoftShadow.ScalingTheWorldChangesNothing, Task4SoftShadow.TheFilterIsAsWideAsThePenumbra, Task4SoftShadow.TheSearchWindowHoldsAllThatCanBlock, Task6WholeShadow.BoxesAgreeWithRays, Task6WholeShadow.FenceAgreesWithRays, Task6WholeShadow.FoliageAgreesWithRays, Task6WholeShadow.HausdorffIsCloserToRays, Task6WholeShadow.SixteenBitsAreEnough, Task6WholeShadow.StairsAgreeWithRays · the second and the third moment have changed places
vec4 depthMoments(float depth) {
    float z = 2.0 * clamp(depth, 0.0, 1.0) - 1.0;
    return vec4(z, z * z * z, z * z, z * z * z * z);
}
