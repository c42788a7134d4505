vec2 penumbraWidthUv(vec2 widthScaleUv, float receiverDepth, float blockerDepth) {
    return widthScaleUv * max(receiverDepth - blockerDepth, 0.0);
}

float meanBlockerDepth(float depth, float mean, float lit) {
    if (lit > 0.999) return depth;
    return clamp((mean - lit * depth) / (1.0 - lit), 0.0, depth);
}
