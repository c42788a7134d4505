// Fails: Task2ShadowCoordinates.UvAndDepthRunFromZeroToOne, Task4DepthBias.ContactShadowStartsWithinOneAndAHalfTexels, Task4DepthBias.NoAcneOnAPlaneFrom10To89Degrees, Task6SecondDepth.NoBiasIsNeededForClosedBlockers, Task7WholeShadow.BoxesAgreeWithRays, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.FoliageAgreesWithRays, Task7WholeShadow.StairsAgreeWithRays · normalised device coordinates in [-1, 1] used as if they were [0, 1]
vec4 lightClipPosition(vec3 world, mat4 clipFromWorld) { return clipFromWorld * vec4(world, 1.0); }

vec3 shadowMapUvDepth(vec4 lightClip) { return lightClip.xyz / lightClip.w; }
