// Task 2: sixteen bits for a moment, and the bias.
#include <cmath>

#include "moment_checks.h"

namespace penumbra {
namespace {

dvec4 code(const dvec4& b) {
    const double root = std::sqrt(3.0);
    return {1.5 * b.x - 2 * b.z + 0.5, 4 * (b.y - b.w), root / 2 * b.x - 2 * root / 9 * b.z + 0.5,
            (b.y + b.w) / 2};
}

Rows randomMoments(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    Rows moments;
    for (int i = 0; i < kRows; ++i) moments.emplace_back(randomDistribution(dice).moments());
    return moments;
}

const RowTolerance kRounding{.absolute = 2e-6,
                             .components = 4,
                             .cause = "moments are rounded to 6e-8, and factors are up to 4"};

TEST(Task2Quantization, CodesAreThoseOfTheOptimisedBasis) {
    const Rows moments = randomMoments(21);
    Rows truth;
    for (const vec4& b : moments) truth.emplace_back(code(b));
    const Rows quantizedMoments = evaluate({.chunk = "quantize.glsl",
                                            .expression = "quantizedMoments(a)",
                                            .inputs = {{"a", moments}}});
    EXPECT_ROWS_NEAR(quantizedMoments, truth, kRounding);
}

TEST(Task2Quantization, DecodingGivesTheMomentsBack) {
    const Rows moments = randomMoments(23);
    Rows codes;
    for (const vec4& b : moments) codes.emplace_back(code(b));
    const Rows dequantizedMoments = evaluate({.chunk = "quantize.glsl",
                                              .expression = "dequantizedMoments(a)",
                                              .inputs = {{"a", codes}}});
    EXPECT_ROWS_NEAR(dequantizedMoments, moments, kRounding);
}

TEST(Task2Quantization, TheBiasLeadsToMinusOneZeroAndOne) {
    Dice dice{std::mt19937(25)};
    const Rows moments = randomMoments(25);
    Rows alphas, truth;
    for (int i = 0; i < kRows; ++i) {
        const double alpha = i % 4 == 0 ? i / 4 % 2 : std::pow(10, dice(-6, 0));
        alphas.emplace_back(float(alpha));
        truth.emplace_back(biased(dvec4(moments[std::size_t(i)]), alphas.back().x));
    }
    const Rows biasedMoments = evaluate({.chunk = "quantize.glsl",
                                         .expression = "biasedMoments(a, b.x)",
                                         .inputs = {{"a", moments}, {"b", alphas}}});
    EXPECT_ROWS_NEAR(
        biasedMoments, truth,
        {.absolute = 2e-7, .relative = 0, .components = 4, .cause = "three roundings to 6e-8"});
}

}  // namespace
}  // namespace penumbra
