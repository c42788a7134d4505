// Fails: Task1Penumbra.SearchWindowHoldsABlockerOnTheNearPlane · receivers behind the far plane search as if they lay on it
vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) { return widthScaleUv * clamp(receiverDepth, 0.0, 1.0); }

vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}
