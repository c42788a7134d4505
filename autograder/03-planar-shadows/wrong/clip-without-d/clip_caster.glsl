// Fails: Task4Clip.DistancesAreLinearInTheCaster, Task4Clip.SignsTellWhatStandsBetween, Task4Clip.StraddlingTrianglesCastTheExactPolygon, Task5RayForm.DrawsTheExactPolygon · n·v instead of n·v + d
vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    float height = dot(plane.xyz, caster);
    return vec2(height, dot(plane.xyz, light.xyz) - light.w * height);
}
