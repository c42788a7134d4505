vec4 flattenAlongRay(vec4 plane, vec4 light, vec3 caster) {
    vec3 towardsLight = light.xyz - light.w * caster;
    float w = dot(plane.xyz, towardsLight);
    float height = dot(plane, vec4(caster, 1.0));
    return vec4(w * caster - height * towardsLight, w);
}
