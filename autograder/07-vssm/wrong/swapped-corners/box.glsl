// Fails: Task3Boxes.BeyondTheBorderDepthIsOne, Task3Boxes.FourCornersMakeAnyBoxAndPartsOfTexels, Task6SoftShadows.AHalfPlanesPenumbraIsALinearRamp, Task6SoftShadows.ATinyLightCastsAHardShadowAndAHugeOneStaysFinite, Task6SoftShadows.CellsCountByTheirShareOfBlockers, Task6SoftShadows.EachCellIsComparedOnTheReceiversPlane, Task6SoftShadows.TheFirstWindowHoldsAllThatCanBlock, Task6SoftShadows.TheNextWindowIsAsWideAsWhatWasFound, Task6SoftShadows.WhereNothingBlocksTheHorizonAloneCounts, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · two corners of the box are swapped
vec2 tableUv(vec2 corner, vec2 texelSizeUv) { return (corner - 0.5) * texelSizeUv; }

vec2 boxSum(vec2 lowLow, vec2 highLow, vec2 lowHigh, vec2 highHigh) { return highHigh - lowLow - highLow + lowHigh; }

vec2 withBorder(vec2 meanInside, float shareInside, float center) {
    float border = 1.0 - center;
    return mix(vec2(border, border * border), meanInside, shareInside);
}

vec2 meanVariance(vec2 moments, float center, float minVariance) {
    return vec2(moments.x + center, max(moments.y - moments.x * moments.x, minVariance));
}
