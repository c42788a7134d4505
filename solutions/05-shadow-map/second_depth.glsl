bool isFirstSurface(float depth, float firstDepth, float depthResolution) { return depth <= firstDepth + depthResolution; }

float midpointDepth(float firstDepth, float secondDepth) { return 0.5 * (firstDepth + secondDepth); }
