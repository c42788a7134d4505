// The square light, or the point light at its centre. Twin: LightBlock in render/uniforms.h.
layout(std140) uniform Light {
    mat4 viewFromWorld;  // light view space: x right, y up, looks along -z
    vec3 center;         // world
    float width;         // full width of the square, world units
    vec3 right;          // unit, along an edge
    vec3 up;             // unit, along the other edge
    vec3 forward;        // unit, where the light shines to
    vec3 color;          // linear
} light;
