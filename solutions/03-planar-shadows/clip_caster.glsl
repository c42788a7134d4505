vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    float height = dot(plane, vec4(caster, 1.0));
    return vec2(height, dot(plane, light) - light.w * height);
}
