// Fails: Task7SeveralLights.LightEndsAtItsRangeAndItsPlane, Task8WholeShadow.CullingLeavesNoTrace, Task8WholeShadow.LanternsOfTheCourtyardAgreeWithRays · light has no range
#include "shading.glsl"

vec3 firstPass(vec3 baseColor, vec3 p, vec3 vertexNormal, vec3 facet) { return ambientAndEmissive(baseColor); }

float reachesReceiver(vec3 p, vec3 facet) {
    vec3 toLight = towardsLight(p);
    bool aboveFacet = dot(facet, toLight) > 0.0;
    bool inRange = length(toLight) * light.inverseRange < 1.0;
    bool beforeLight = light.position.w == 0.0 || dot(light.forward, toLight) < 0.0;
    return aboveFacet && beforeLight ? 1.0 : 0.0;
}

vec3 lightPass(vec3 baseColor, vec3 p, vec3 vertexNormal, vec3 facet) {
    return reachesReceiver(p, facet) * directLight(baseColor, p, vertexNormal, facet);
}
