// Fails: Task5RayForm.DrawsTheExactPolygon, Task5RayForm.FlattenedPointsAreLinearInTheCaster, Task5RayForm.PointsLieOnTheirRays · l - v for a directional light, too
vec4 flattenAlongRay(vec4 plane, vec4 light, vec3 caster) {
    vec3 towardsLight = light.xyz - caster;
    float w = dot(plane.xyz, towardsLight);
    float height = dot(plane, vec4(caster, 1.0));
    return vec4(w * caster - height * towardsLight, w);
}
