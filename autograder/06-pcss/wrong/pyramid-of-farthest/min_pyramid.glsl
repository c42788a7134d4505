// Fails: Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task6MinPyramid.EveryTexelKnowsTheNearestOfItsWindow, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays · each level holds the farthest of four depths
float nearestOfFour(vec4 depths) { return max(max(depths.x, depths.y), max(depths.z, depths.w)); }

int windowRadiusTexels(float windowUv, float texelUv) { return int(ceil(0.5 * windowUv / texelUv)); }

vec2 narrowedWidthUv(vec2 widthUv, vec2 widthScaleUv, float receiverDepth, float nearestDepth) {
    return min(widthUv, widthScaleUv * max(receiverDepth - nearestDepth, 0.0));
}
