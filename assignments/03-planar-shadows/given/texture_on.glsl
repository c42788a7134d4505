#include "planar.glsl"
#include "shadow_texture.glsl"

uniform sampler2D shadowTexture;

float castVisibility(vec3 worldPosition) {
    vec4 textureClip = planar.textureClipFromWorld * vec4(worldPosition, 1.0);
    float texel = textureLod(shadowTexture, shadowTextureUv(textureClip), 0.0).r;
    return mix(planar.shadowVisibility, 1.0, shadowTextureVisibility(texel, textureClip));
}
