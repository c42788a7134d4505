// Direct light times visibility, plus ambient light that no shadow touches.
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

// Lambert; the vertex normal is turned to the facet's side, since surfaces are two-sided.
vec3 shade(vec3 baseColor, vec3 worldPosition, vec3 vertexNormal, vec3 facet, float visibility) {
    vec3 n = normalize(dot(vertexNormal, facet) < 0.0 ? -vertexNormal : vertexNormal);
    float cosine = max(dot(n, normalize(light.center - worldPosition)), 0.0);
    return baseColor * (kAmbient + (1.0 - kAmbient) * visibility * cosine * light.color);
}
