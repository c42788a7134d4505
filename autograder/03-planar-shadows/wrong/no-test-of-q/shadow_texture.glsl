// Fails: Task6ShadowTexture.BehindTheLightIsLight, Task6ShadowTexture.NoMirroredShadowBehindTheLight · w < 0 is not asked for: receivers behind the light get a mirrored shadow
vec2 shadowTextureUv(vec4 textureClip) { return 0.5 * textureClip.xy / textureClip.w + 0.5; }

float shadowTextureVisibility(float texel, vec4 textureClip) {
    vec2 uv = shadowTextureUv(textureClip);
    return clamp(uv, 0.0, 1.0) == uv ? texel : 1.0;
}
