// Fails: Task2ShadowCoordinates.UvAndDepthRunFromZeroToOne, Task4DepthBias.ContactShadowStartsWithinOneAndAHalfTexels, Task4DepthBias.NoAcneOnAPlaneFrom10To89Degrees, Task6SecondDepth.NoBiasIsNeededForClosedBlockers, Task7WholeShadow.BoxesAgreeWithRays, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.FoliageAgreesWithRays, Task7WholeShadow.StairsAgreeWithRays · v counted from the top, as in image files
vec4 lightClipPosition(vec3 world, mat4 clipFromWorld) { return clipFromWorld * vec4(world, 1.0); }

vec3 shadowMapUvDepth(vec4 lightClip) {
    vec3 uvDepth = 0.5 * lightClip.xyz / lightClip.w + 0.5;
    uvDepth.y = 1.0 - uvDepth.y;
    return uvDepth;
}
