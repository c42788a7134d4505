// Fails: Task6SecondDepth.ThresholdIsMidway · the second depth itself instead of the midpoint
bool isFirstSurface(float depth, float firstDepth, float depthResolution) { return depth <= firstDepth + depthResolution; }

float midpointDepth(float firstDepth, float secondDepth) { return secondDepth; }
