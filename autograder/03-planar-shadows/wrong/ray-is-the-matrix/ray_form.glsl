// Fails: Task5RayForm.StaysAccurateAsTheCasterNearsTheLightsHeight · the matrix product written out: right, and ten times less accurate near the light
vec4 flattenAlongRay(vec4 plane, vec4 light, vec3 caster) {
    float scale = dot(plane, light);
    vec4 v = vec4(caster, 1.0);
    return scale * v - dot(plane, v) * light;
}
