// Fails: Task4Bound.AThirdDepthGetsLightAsTheBoundSays, Task4Bound.TheFartherOfTwoDepthsIsExact, Task6SoftShadows.AHalfPlanesPenumbraIsALinearRamp, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound, Task7Exponential.TheLesserOfTwoBounds, Task7Exponential.WholeFramesAreFilteredByTheWarps, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · the bound with the standard deviation in place of the variance
#include "error_function.glsl"

float chebyshev(float depth, vec2 meanVariance) {
    float beyond = depth - meanVariance.x;
    if (beyond <= 0.0) return 1.0;
    float deviation = sqrt(meanVariance.y);
    return deviation / (deviation + beyond * beyond);
}

float lessBleeding(float bound, float amount) { return clamp((bound - amount) / (1.0 - amount), 0.0, 1.0); }

float normalTail(float depth, vec2 meanVariance) {
    float deviation = sqrt(max(meanVariance.y, 1e-20));
    return 0.5 - 0.5 * errorFunction((depth - meanVariance.x) / (deviation * 1.4142135624));
}
