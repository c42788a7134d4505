// Fails: Task5Signed.ARayAlongTheSurfaceSeesHalfTheLight, Task5Signed.ASlabsPenumbraIsALinearRamp, Task5Signed.AThinSlabLeaksByItsThickness, Task5Signed.BoxesAndFenceAgreeWithRays · a ray along the surface sees nothing, not half the light
#include "lecture.glsl"

float signedVisibility(float ratio, float edgeRatio) { return clamp(safeTangent(ratio) / edgeRatio, 0.0, 1.0); }
