// Fails: Task6ShadowTexture.CurvedReceiverAgreesWithRays, Task6ShadowTexture.NoMirroredShadowBehindTheLight, Task6ShadowTexture.UvRunsFromZeroToOne, Task7WholeShadow.FoliageAgreesWithRays · v counted from the top, as in image files
vec2 shadowTextureUv(vec4 textureClip) { return vec2(0.5, -0.5) * textureClip.xy / textureClip.w + 0.5; }

float shadowTextureVisibility(float texel, vec4 textureClip) {
    bool inside = textureClip.w > 0.0 && max(abs(textureClip.x), abs(textureClip.y)) <= textureClip.w;
    return inside ? texel : 1.0;
}
