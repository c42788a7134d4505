// Fails: Task6ShadowTexture.BesideTheTextureIsLight, Task6ShadowTexture.CurvedReceiverAgreesWithRays · the border's texels go on beside the texture
vec2 shadowTextureUv(vec4 textureClip) { return 0.5 * textureClip.xy / textureClip.w + 0.5; }

float shadowTextureVisibility(float texel, vec4 textureClip) {
    return textureClip.w > 0.0 ? texel : 1.0;
}
