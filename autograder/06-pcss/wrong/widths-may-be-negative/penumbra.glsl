// Fails: Task1Penumbra.WidthsAreNeverNegative · widths are not kept from becoming negative
vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) { return widthScaleUv * receiverDepth; }

vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * (receiverDepth - blockerDepth);
}
