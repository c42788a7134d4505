// Fails: Task3DepthTest.Filter2x2WeighsComparisonsBilinearly, Task7WholeShadow.StairsAgreeWithRays · texels 1 and 2 swapped in the bilinear mean
float litBy(float storedDepth, float receiverDepth) { return receiverDepth <= storedDepth ? 1.0 : 0.0; }

float filter2x2(vec4 storedDepths, vec4 receiverDepths, vec2 fraction) {
    vec4 lit = vec4(lessThanEqual(receiverDepths, storedDepths));
    vec2 rows = mix(lit.xy, lit.zw, fraction.x);
    return mix(rows.x, rows.y, fraction.y);
}
