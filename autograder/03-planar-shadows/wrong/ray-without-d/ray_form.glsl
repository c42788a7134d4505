// Fails: Task5RayForm.DrawsTheExactPolygon, Task5RayForm.FlattenedPointsAreLinearInTheCaster, Task5RayForm.PointsLieOnTheirRays, Task5RayForm.StaysAccurateAsTheCasterNearsTheLightsHeight, Task5RayForm.StraddlingTrianglesKeepTheExactPolygonsArea, Task7WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task7WholeShadow.LowLightsCastLongShadows · the height over the plane without d
vec4 flattenAlongRay(vec4 plane, vec4 light, vec3 caster) {
    vec3 towardsLight = light.xyz - light.w * caster;
    float w = dot(plane.xyz, towardsLight);
    float height = dot(plane.xyz, caster);
    return vec4(w * caster - height * towardsLight, w);
}
