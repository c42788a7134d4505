// Fails: Task5OutsideMap.BesideTheMapAndBeforeTheNearPlaneIsLit · receivers outside the map are dark
const float kInsideMap = -1.0;

float visibilityOutsideMap(vec4 lightClip) {
    bool outside = max(abs(lightClip.x), abs(lightClip.y)) > lightClip.w || lightClip.z < -lightClip.w;
    return lightClip.w <= 0.0 ? 0.0 : outside ? 0.0 : kInsideMap;
}
