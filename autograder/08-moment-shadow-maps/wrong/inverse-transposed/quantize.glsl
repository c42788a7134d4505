// Fails: Task2Quantization.DecodingGivesTheMomentsBack, Task6WholeShadow.SixteenBitsAreEnough · the decoding matrix is transposed
const float kRoot = 1.7320508076;  // sqrt(3)

vec4 quantizedMoments(vec4 b) {
    return vec4(1.5 * b.x - 2.0 * b.z + 0.5, 4.0 * (b.y - b.w), kRoot * (b.x / 2.0 - b.z * 2.0 / 9.0) + 0.5, 0.5 * (b.y + b.w));
}

vec4 dequantizedMoments(vec4 q) {
    const mat4 inverse = mat4(-1.0 / 3.0, 0.0, -0.75, 0.0, 0.0, 0.125, 0.0, -0.125, kRoot, 0.0, 0.75 * kRoot, 0.0, 0.0, 1.0, 0.0, 1.0);
    return (q - vec4(0.5, 0.0, 0.5, 0.0)) * inverse;
}

vec4 biasedMoments(vec4 b, float alpha) { return mix(b, vec4(0.0, 0.6, 0.0, 0.6), alpha); }
