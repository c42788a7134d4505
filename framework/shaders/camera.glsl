// The eye's view. Twin: CameraBlock in render/uniforms.h.
layout(std140) uniform Camera {
    mat4 clipFromWorld;
    mat4 viewFromWorld;
    vec3 eye;  // world
} camera;
