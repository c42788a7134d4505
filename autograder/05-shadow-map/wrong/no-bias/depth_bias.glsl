// Fails: Task4DepthBias.ConstantBiasIsCountedInTexels, Task4DepthBias.GradientSolvesTheReceiversPlane, Task4DepthBias.NoAcneOnAPlaneFrom10To89Degrees, Task4DepthBias.NormalOffsetFollowsTheSine, Task4DepthBias.PlaneBiasReachesTheFarthestTexelCentre, Task4DepthBias.SlopeBiasFollowsTheTangent, Task7WholeShadow.BoxesAgreeWithRays, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.FoliageAgreesWithRays, Task7WholeShadow.StairsAgreeWithRays · no depth bias at all
float constantBias(float texels, float texelSize) { return 0.0; }

float slopeBias(float texels, float texelSize, float cosTheta) { return 0.0; }

vec3 normalOffset(vec3 facet, float cosTheta, float texels, float texelSize) { return vec3(0.0); }

vec2 receiverPlaneGradient(vec3 dx, vec3 dy) { return vec2(0.0); }

float receiverPlaneBias(vec2 gradient, vec2 texelSizeUv, float radiusTexels) { return 0.0; }
