// Task 6a · one step up the pyramid.                                                       README §6
//   depths   of the four texels that become one
// Returns a depth that none of them is nearer than.
float nearestOfFour(vec4 depths) {
    return 0.0;  // yours; sound, and of no use: anything might be just before the light
}

// Task 6b · how far a search window reaches, counted in texels of the pyramid.             README §6
//   windowUv   full width of the widest window, centred anywhere in a texel                [uv]
//   texelUv    width of a texel                                                            [uv]
// Returns the smallest whole number n such that the texel and its n neighbours on both sides hold the window.
int windowRadiusTexels(float windowUv, float texelUv) {
    return 0;  // yours
}

// Task 6c · a narrower search window, sound.                                               README §6
//   widthUv        of the window that holds every possible blocker                         [uv]
//   widthScaleUv   S of Task 1                                                             [uv]
//   nearestDepth   nothing in the window has a smaller depth
// Returns a width that still holds every blocker: never wider than widthUv, 0 where nothing in the window is nearer
// than the receiver.
vec2 narrowedWidthUv(vec2 widthUv, vec2 widthScaleUv, float receiverDepth, float nearestDepth) {
    return widthUv;  // yours
}
