// Fails: Task4Bound.WhatIsNotFartherThanTheMeanIsLit, Task6SoftShadows.AHalfPlanesPenumbraIsALinearRamp, Task6SoftShadows.ATinyLightCastsAHardShadowAndAHugeOneStaysFinite, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.WhereNothingBlocksTheHorizonAloneCounts, Task7Exponential.TheLesserOfTwoBounds, Task7Exponential.WholeFramesAreFilteredByTheWarps, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · Chebyshev's bound on both sides of the mean
#include "error_function.glsl"

float chebyshev(float depth, vec2 meanVariance) {
    float beyond = depth - meanVariance.x;
    return meanVariance.y / (meanVariance.y + beyond * beyond);
}

float lessBleeding(float bound, float amount) { return clamp((bound - amount) / (1.0 - amount), 0.0, 1.0); }

float normalTail(float depth, vec2 meanVariance) {
    float deviation = sqrt(max(meanVariance.y, 1e-20));
    return 0.5 - 0.5 * errorFunction((depth - meanVariance.x) / (deviation * 1.4142135624));
}
