// What a surface is made of. Twin: MaterialBlock in render/gpu_scene.cpp.
layout(std140) uniform Material {
    vec3 baseColor;     // linear, multiplies the texture
    float alphaCutoff;  // > 0: the surface has a hole where the texture's alpha is below
    vec3 emissive;      // linear
} material;

uniform sampler2D baseColorTexture;

// Level 0 on purpose: a smaller level has other holes than the ones that cast the shadow.
vec4 baseColorSample(vec2 uv) { return textureLod(baseColorTexture, uv, 0.0); }

bool isHole(vec2 uv) { return baseColorSample(uv).a < material.alphaCutoff; }
