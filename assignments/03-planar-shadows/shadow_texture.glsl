// The shadow texture holds the casters as the light sees them: 0 where a caster is, 1 the background. [Segal 1992]

// Task 6a · where to look.                                                               README §6
//   textureClip   the receiver, projected as the casters were; w > 0
// Returns (u, v): [0,1]² inside the texture, v upwards.
vec2 shadowTextureUv(vec4 textureClip) {
    return vec2(0.5);  // yours
}

// Task 6b · what it means.                                                               README §6
//   texel         of the texture at shadowTextureUv(); beyond its border a copy of the border's texel; anything
//                 where w <= 0
//   textureClip   as above, with any w
// Returns the visibility in [0,1]: the texel inside the texture; 1 beside its four sides, where the background goes
// on, and 1 where w <= 0: there the projection mirrors what is on the other side.
float shadowTextureVisibility(float texel, vec4 textureClip) {
    return 1.0;  // yours
}
