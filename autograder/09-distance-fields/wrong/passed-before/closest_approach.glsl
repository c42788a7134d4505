// Fails: Task4ClosestApproach.WhereTheCirclesDoNotMeetBetweenOnlyTheLookUpCounts · a place passed before the look-up before counts again
vec2 closestApproach(float before, float here, float stepTaken) {
    if (stepTaken <= 0.0 || before <= 0.0 || here <= 0.0) return vec2(0.0, here);
    float back = (here * here - before * before + stepTaken * stepTaken) / (2.0 * stepTaken);
    if (back <= 0.0) return vec2(0.0, here);
    return vec2(back, sqrt(max(here * here - back * back, 0.0)));
}
