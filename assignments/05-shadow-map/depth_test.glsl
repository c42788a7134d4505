// Task 3a · one comparison.                                                              README §3, [Williams 1978]
//   storedDepth     depth of the first surface that the light met in this texel          [0,1]
//   receiverDepth   depth of the point that asks                                         [0,1]
// Returns 1 where nothing nearer to the light is stored (equal depths are lit), else 0.
float litBy(float storedDepth, float receiverDepth) {
    return 1.0;  // yours
}

// Task 3b · the four texels around the receiver, bilinear.                               README §3, [Reeves 1987]
//   storedDepths     x y z w = texels 0 1 2 3:   2 --- 3
//   receiverDepths   one for each texel          | *   |   fraction = position of * from texel 0, [0,1]²
//   fraction                                     0 --- 1
// Returns the share of the light: at a texel's centre that texel's comparison, between them a bilinear mean
// of comparisons. Depths are never averaged.
float filter2x2(vec4 storedDepths, vec4 receiverDepths, vec2 fraction) {
    return 1.0;  // yours
}
