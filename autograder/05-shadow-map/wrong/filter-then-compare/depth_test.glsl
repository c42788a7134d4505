// Fails: Task3DepthTest.Filter2x2WeighsComparisonsBilinearly, Task3DepthTest.NeverAveragesDepths, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.FoliageAgreesWithRays, Task7WholeShadow.StairsAgreeWithRays · depths are averaged first and compared afterwards
float litBy(float storedDepth, float receiverDepth) { return receiverDepth <= storedDepth ? 1.0 : 0.0; }

float filter2x2(vec4 storedDepths, vec4 receiverDepths, vec2 fraction) {
    vec2 stored = mix(storedDepths.xz, storedDepths.yw, fraction.x);
    vec2 receiver = mix(receiverDepths.xz, receiverDepths.yw, fraction.x);
    return litBy(mix(stored.x, stored.y, fraction.y), mix(receiver.x, receiver.y, fraction.y));
}
