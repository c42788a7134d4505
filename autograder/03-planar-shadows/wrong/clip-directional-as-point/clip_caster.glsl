// Fails: Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.SignsTellWhatStandsBetween, Task4Clip.StraddlingTrianglesCastTheExactPolygon, Task5RayForm.DrawsTheExactPolygon · what is higher than a directional light's unit vector is cut off
vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    float height = dot(plane, vec4(caster, 1.0));
    return vec2(height, dot(plane, light) - height);
}
