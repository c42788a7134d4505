const float kInsideMap = -1.0;

float visibilityOutsideMap(vec4 lightClip) {
    if (lightClip.w <= 0.0) return 0.0;
    if (any(greaterThan(abs(lightClip.xy), vec2(lightClip.w))) || lightClip.z < -lightClip.w) return 1.0;
    return kInsideMap;
}
