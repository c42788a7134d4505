// Fails: Task5RayForm.DrawsTheExactPolygon, Task5RayForm.FlattenedPointsAreLinearInTheCaster, Task7WholeShadow.LowLightsCastLongShadows · divided by w: the sign that tells antishadow is gone, and the rasteriser interpolates points
vec4 flattenAlongRay(vec4 plane, vec4 light, vec3 caster) {
    vec3 towardsLight = light.xyz - light.w * caster;
    float w = dot(plane.xyz, towardsLight);
    float height = dot(plane, vec4(caster, 1.0));
    return vec4(caster - height / w * towardsLight, 1.0);
}
