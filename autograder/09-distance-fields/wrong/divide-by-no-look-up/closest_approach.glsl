// Fails: Task4ClosestApproach.APostBetweenTwoLookUpsIsMetExactly, Task4ClosestApproach.TheMarchCountsWhatLiesBetweenItsLookUps, Task4ClosestApproach.WhereTheCirclesDoNotMeetBetweenOnlyTheLookUpCounts · the formula for full steps, also before the first one and where steps are short
vec2 closestApproach(float before, float here, float stepTaken) {
    float back = here * here / (2.0 * before);
    return vec2(back, sqrt(here * here - back * back));
}
