// Direct light times visibility, plus ambient and emitted light, which no shadow touches.
#include "light.glsl"
#include "material.glsl"

const float kAmbient = 0.22;

// Normal of the triangle's plane on the eye's side, exact for a flat facet whatever its vertex normals.
vec3 facetNormal(vec3 worldPosition, vec3 eye) {
    vec3 n = cross(dFdx(worldPosition), dFdy(worldPosition));
    float size = length(n);
    n = size > 0.0 ? n / size : normalize(eye - worldPosition);
    return dot(n, eye - worldPosition) < 0.0 ? -n : n;
}

vec3 ambientAndEmissive(vec3 baseColor) { return kAmbient * baseColor + material.emissive; }

// One light's own share. Lambert; the vertex normal is turned to the facet's side, since surfaces are two-sided.
vec3 directLight(vec3 baseColor, vec3 worldPosition, vec3 vertexNormal, vec3 facet) {
    vec3 n = normalize(dot(vertexNormal, facet) < 0.0 ? -vertexNormal : vertexNormal);
    vec3 toLight = towardsLight(worldPosition);
    float distance = length(toLight);
    float cosine = max(dot(n, toLight) / distance, 0.0);
    return baseColor * ((1.0 - kAmbient) * cosine * lightFalloff(distance) * light.color);
}

vec3 shade(vec3 baseColor, vec3 worldPosition, vec3 vertexNormal, vec3 facet, float visibility) {
    return ambientAndEmissive(baseColor) +
           visibility * directLight(baseColor, worldPosition, vertexNormal, facet);
}
