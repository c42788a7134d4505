vec2 searchWidthUv(vec2 widthScaleUv, float receiverDepth) { return widthScaleUv * max(receiverDepth, 0.0); }

vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}
