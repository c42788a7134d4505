// Fails: Task2March.ASphereIsMetAtItsClosedForm, Task2March.ItEndsWhereNothingDarkerCanCome, Task2March.TheErrorFallsWithTheSquareOfTheStepCap, Task2March.WhatLiesBehindTheLightBlocksNothing, Task3Lecture.ASlabsShadowFollowsTheFormula, Task4ClosestApproach.TheMarchCountsWhatLiesBetweenItsLookUps, Task5Signed.ASlabsPenumbraIsALinearRamp, Task5Signed.AThinSlabLeaksByItsThickness, Task5Signed.BoxesAndFenceAgreeWithRays, Task6Edge.ATurnedSlabHidesAnExactShare, Task7WholeShadow.BoxesAgreeWithRays, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.ScalingTheWorldChangesNothing, Task7WholeShadow.StairsAgreeWithRays · the last look-up's ratio is kept, not the least
#include "march_limits.glsl"

float sceneDistance(vec3 p);
vec2 approachSince(float before, float here, float stepTaken);

vec3 rayStart(vec3 position, vec3 normal, float offset) { return position + offset * normal; }

float stepLength(float distance, float t, float ratio, float stepCap, float smallestStep) {
    float sound = (distance - ratio * t) / (1.0 + ratio);
    return max(max(sound, stepCap * abs(distance)), smallestStep);
}

Approach march(vec3 origin, vec3 direction, float first, float reach, Limits limits) {
    Approach nearest = Approach(limits.highest, reach, 0.0);
    float t = first, before = 0.0, stepTaken = 0.0;
    for (int i = 0; i < limits.maxSteps; ++i) {
        if (t >= reach || nearest.ratio <= limits.lowest) break;
        float here = sceneDistance(origin + t * direction);
        nearest.steps += 1.0;
        vec2 since = approachSince(before, here, stepTaken);
        float at = t - since.x, ratio = since.y / at;
        nearest.ratio = ratio, nearest.t = at;
        before = here;
        stepTaken = stepLength(here, t, nearest.ratio, limits.stepCap, limits.smallestStep);
        t += stepTaken;
    }
    return nearest;
}
