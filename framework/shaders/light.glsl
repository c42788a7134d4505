// The square light, the point light at its centre, or a directional light. Twin: LightBlock in render/uniforms.h.
layout(std140) uniform Light {
    mat4 viewFromWorld;  // light view space: x right, y up, looks along -z
    vec3 center;         // world
    float width;         // full width of the square, world units
    vec3 right;          // unit, along an edge
    vec3 up;             // unit, along the other edge
    vec3 forward;        // unit, where the light shines to
    vec3 color;          // linear
    float inverseRange;  // 1 / world units; 0: it reaches without end
    vec4 position;       // w 1: center; w 0: direction to the light
} light;

// From p towards the light, not normalised: as long as it is far, or 1 for a directional light.
vec3 towardsLight(vec3 p) { return light.position.xyz - light.position.w * p; }

// Share of the light that reaches so far: (1 - (distance / range)²)², 0 beyond.
float lightFalloff(float distance) {
    float t = distance * light.inverseRange;
    float rest = max(1.0 - t * t, 0.0);
    return rest * rest;
}
