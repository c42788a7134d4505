// Fails: Task6MinPyramid.TheNarrowedWindowHoldsEveryBlocker · the nearest depth alone makes the window, however narrow it was
float nearestOfFour(vec4 depths) { return min(min(depths.x, depths.y), min(depths.z, depths.w)); }

int windowRadiusTexels(float windowUv, float texelUv) { return int(ceil(0.5 * windowUv / texelUv)); }

vec2 narrowedWidthUv(vec2 widthUv, vec2 widthScaleUv, float receiverDepth, float nearestDepth) {
    return widthScaleUv * max(receiverDepth - nearestDepth, 0.0);
}
