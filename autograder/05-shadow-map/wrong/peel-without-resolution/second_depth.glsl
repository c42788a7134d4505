// Fails: Task6SecondDepth.NoBiasIsNeededForClosedBlockers, Task6SecondDepth.PeelsTheFirstSurfaceAndNothingElse · peeling without allowance for rounded depths
bool isFirstSurface(float depth, float firstDepth, float depthResolution) { return depth <= firstDepth; }

float midpointDepth(float firstDepth, float secondDepth) { return 0.5 * (firstDepth + secondDepth); }
