// Fails: Task3Boxes.BeyondTheBorderDepthIsOne, Task3Boxes.FourCornersMakeAnyBoxAndPartsOfTexels, Task3Boxes.TheTableIsReadAtCornersOfTexels, Task6SoftShadows.AHalfPlanesPenumbraIsALinearRamp, Task6SoftShadows.WhereNothingBlocksTheHorizonAloneCounts, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · the table is read one texel too far: the box of the next column and row
vec2 tableUv(vec2 corner, vec2 texelSizeUv) { return (corner + 0.5) * texelSizeUv; }

vec2 boxSum(vec2 lowLow, vec2 highLow, vec2 lowHigh, vec2 highHigh) { return highHigh - lowHigh - highLow + lowLow; }

vec2 withBorder(vec2 meanInside, float shareInside, float center) {
    float border = 1.0 - center;
    return mix(vec2(border, border * border), meanInside, shareInside);
}

vec2 meanVariance(vec2 moments, float center, float minVariance) {
    return vec2(moments.x + center, max(moments.y - moments.x * moments.x, minVariance));
}
