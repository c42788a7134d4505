// Fails: Task2Quantization.CodesAreThoseOfTheOptimisedBasis, Task2Quantization.DecodingGivesTheMomentsBack, Task6WholeShadow.SixteenBitsAreEnough · each moment by itself in 16 bits
const float kRoot = 1.7320508076;  // sqrt(3)

vec4 quantizedMoments(vec4 b) {
    return 0.5 * b + 0.5;
}

vec4 dequantizedMoments(vec4 q) {
    return 2.0 * q - 1.0;
}

vec4 biasedMoments(vec4 b, float alpha) { return mix(b, vec4(0.0, 0.6, 0.0, 0.6), alpha); }
