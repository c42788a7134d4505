// Fails: Task4Clip.ACasterAboveTheLightHasNoAntishadow, Task4Clip.DistancesAreLinearInTheCaster, Task4Clip.SignsTellWhatStandsBetween · what is farther than the light stays: antishadow
vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    float height = dot(plane, vec4(caster, 1.0));
    return vec2(height, 1.0);
}
