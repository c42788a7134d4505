// Fails: Task6ShadowTexture.CurvedReceiverAgreesWithRays, Task6ShadowTexture.NoMirroredShadowBehindTheLight, Task6ShadowTexture.UvRunsFromZeroToOne, Task7WholeShadow.FoliageAgreesWithRays · clip coordinates used as if they ran from 0 to 1
vec2 shadowTextureUv(vec4 textureClip) { return textureClip.xy / textureClip.w; }

float shadowTextureVisibility(float texel, vec4 textureClip) {
    bool inside = textureClip.w > 0.0 && max(abs(textureClip.x), abs(textureClip.y)) <= textureClip.w;
    return inside ? texel : 1.0;
}
