// Fails: Task6ShadowTexture.CurvedReceiverAgreesWithRays, Task6ShadowTexture.NoMirroredShadowBehindTheLight, Task6ShadowTexture.UvRunsFromZeroToOne, Task7WholeShadow.FoliageAgreesWithRays · no division by w: right for a directional light alone
vec2 shadowTextureUv(vec4 textureClip) { return 0.5 * textureClip.xy + 0.5; }

float shadowTextureVisibility(float texel, vec4 textureClip) {
    bool inside = textureClip.w > 0.0 && max(abs(textureClip.x), abs(textureClip.y)) <= textureClip.w;
    return inside ? texel : 1.0;
}
