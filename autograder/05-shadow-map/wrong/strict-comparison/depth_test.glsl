// Fails: Task3DepthTest.EqualDepthsAreLit, Task4DepthBias.NoAcneOnAPlaneFrom10To89Degrees · equal depths count as blocked
float litBy(float storedDepth, float receiverDepth) { return receiverDepth < storedDepth ? 1.0 : 0.0; }

float filter2x2(vec4 storedDepths, vec4 receiverDepths, vec2 fraction) {
    vec4 lit = vec4(lessThan(receiverDepths, storedDepths));
    vec2 rows = mix(lit.xz, lit.yw, fraction.x);
    return mix(rows.x, rows.y, fraction.y);
}
