// Fails: Task5OutsideMap.BehindTheLightIsDark, Task5OutsideMap.NoMirroredShadowBehindTheLight · receivers behind the light are treated as if they stood before it
const float kInsideMap = -1.0;

float visibilityOutsideMap(vec4 lightClip) {
    vec3 ndc = lightClip.xyz / lightClip.w;
    bool outside = max(abs(ndc.x), abs(ndc.y)) > 1.0 || ndc.z < -1.0;
    return outside ? 1.0 : kInsideMap;
}
