// Fails: Task6ShadowTexture.BehindTheLightIsLight, Task6ShadowTexture.BesideTheTextureIsLight, Task6ShadowTexture.CurvedReceiverAgreesWithRays, Task6ShadowTexture.NoMirroredShadowBehindTheLight, Task7WholeShadow.FoliageAgreesWithRays · beside the texture and behind the light it is dark
vec2 shadowTextureUv(vec4 textureClip) { return 0.5 * textureClip.xy / textureClip.w + 0.5; }

float shadowTextureVisibility(float texel, vec4 textureClip) {
    bool inside = textureClip.w > 0.0 && max(abs(textureClip.x), abs(textureClip.y)) <= textureClip.w;
    return inside ? texel : 0.0;
}
