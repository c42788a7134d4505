// Fails: Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.DistancesAreLinearInTheCaster, Task4Clip.SignsTellWhatStandsBetween, Task4Clip.StraddlingTrianglesCastTheExactPolygon, Task5RayForm.DrawsTheExactPolygon · what is behind the plane stays: false shadow
vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    float height = dot(plane, vec4(caster, 1.0));
    return vec2(1.0, dot(plane, light) - light.w * height);
}
