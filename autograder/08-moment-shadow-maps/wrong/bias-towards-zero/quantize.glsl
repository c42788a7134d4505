// Fails: Task2Quantization.TheBiasLeadsToMinusOneZeroAndOne, Task4SoftShadow.ARefinementLooksThroughTheFirstBlockers, Task4SoftShadow.EachCellIsComparedBelowItsPartOfThePlane, Task4SoftShadow.TheFilterIsAsWideAsThePenumbra, Task4SoftShadow.TheSearchWindowHoldsAllThatCanBlock, Task6WholeShadow.BoxesAgreeWithRays, Task6WholeShadow.SixteenBitsAreEnough, Task6WholeShadow.StairsAgreeWithRays · the bias leads to the moments of one depth, 0: as singular as before
const float kRoot = 1.7320508076;  // sqrt(3)

vec4 quantizedMoments(vec4 b) {
    return vec4(1.5 * b.x - 2.0 * b.z + 0.5, 4.0 * (b.y - b.w), kRoot * (b.x / 2.0 - b.z * 2.0 / 9.0) + 0.5, 0.5 * (b.y + b.w));
}

vec4 dequantizedMoments(vec4 q) {
    vec2 odd = q.xz - 0.5;
    return vec4(kRoot * odd.y - odd.x / 3.0, q.w + q.y / 8.0, 0.75 * (kRoot * odd.y - odd.x), q.w - q.y / 8.0);
}

vec4 biasedMoments(vec4 b, float alpha) { return mix(b, vec4(0.0), alpha); }
