// Fails: Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task6MinPyramid.EveryTexelKnowsTheNearestOfItsWindow, Task6MinPyramid.TheRadiusReachesTheWindowsEndsFromAnyPlace · the window is not covered to its ends
float nearestOfFour(vec4 depths) { return min(min(depths.x, depths.y), min(depths.z, depths.w)); }

int windowRadiusTexels(float windowUv, float texelUv) { return int(floor(0.5 * windowUv / texelUv)); }

vec2 narrowedWidthUv(vec2 widthUv, vec2 widthScaleUv, float receiverDepth, float nearestDepth) {
    return min(widthUv, widthScaleUv * max(receiverDepth - nearestDepth, 0.0));
}
