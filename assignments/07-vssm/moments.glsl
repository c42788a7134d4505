vec2 momentsFromDepth(float depth, float center) {
    float d = depth - center;
    return vec2(d, d * d);
}
