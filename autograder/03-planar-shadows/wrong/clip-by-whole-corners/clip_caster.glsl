// Fails: Task4Clip.DistancesAreLinearInTheCaster, Task4Clip.StraddlingTrianglesCastTheExactPolygon, Task5RayForm.DrawsTheExactPolygon · signs instead of distances: a straddling triangle is cut halfway between its corners
vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    float height = dot(plane, vec4(caster, 1.0));
    return sign(vec2(height, dot(plane, light) - light.w * height));
}
