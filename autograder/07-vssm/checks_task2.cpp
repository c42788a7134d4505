// Summed areas: whole numbers, so every texel is right or wrong.
#include <cstdint>

#include "variance_checks.h"

namespace penumbra {
namespace {

TEST(Task2SummedAreas, EachPassReachesFourTimesAsFar) {
    Rows passes, truth;
    for (int i = 0; i < 8; ++i) {
        passes.emplace_back(i, 0, 0, 0);
        truth.emplace_back(std::pow(4.0f, float(i)), 0, 0, 0);
    }
    const Rows strideOfPass =
        evaluate({.chunk = "sat.glsl",
                  .expression = "vec4(float(strideOfPass(int(a.x))), 0.0, 0.0, 0.0)",
                  .inputs = {{"a", passes}}});
    EXPECT_ROWS_NEAR(strideOfPass, truth, {.absolute = 0, .relative = 0, .cause = "whole numbers"});
}

// Both sums of each texel, as upper and lower 16 bits, of whole numbers made as README §2 says.
Image exactSums(const Image& moments, double integersPerUnit) {
    const int size = moments.width;
    Image halves(size, size, 4);
    for (int channel = 0; channel < 2; ++channel) {
        std::vector<std::uint32_t> below(std::size_t(size), 0);
        for (int y = size - 1; y >= 0; --y) {  // from the lower left
            std::uint32_t left = 0;
            for (int x = 0; x < size; ++x) {
                const double moment = moments.at(x, y, channel);
                left += std::uint32_t(std::int64_t(std::floor(moment * integersPerUnit + 0.5)));
                const std::uint32_t sum = below[std::size_t(x)] += left;
                halves.at(x, y, 2 * channel) = float(sum >> 16);
                halves.at(x, y, 2 * channel + 1) = float(sum & 0xffff);
            }
        }
    }
    return halves;
}

void expectExactSums(int size, const std::string& center) {
    const glm::ivec2 map(size);
    const Rendered frame = render(
        {.scene = "stairs@3",
         .size = kTiny,
         .settings = {"prefilter=sat_gpu", "map_size=" + std::to_string(size), "center=" + center},
         .images = {{"sat", map}, {"moments", map}, {"integers_per_unit", {1, 1}}}});
    const Image& moments = frame.at("moments");
    const auto [low, high] = std::minmax_element(moments.pixels.begin(), moments.pixels.end());
    EXPECT_VALUE(*high - *low, Greater, 0.1, "there must be something to sum: Task 1");
    EXPECT_IMAGE_NEAR(frame.at("sat"), exactSums(moments, frame.at("integers_per_unit").at(0, 0)),
                      {.maximum = 0, .cause = "whole numbers modulo 2^32: bit for bit"});
}

TEST(Task2SummedAreas, ExactWhereTheSizeIsAPowerOfFour) {
    expectExactSums(64, "mean");
    expectExactSums(256, "zero");  // sums that run over 2^32
}

TEST(Task2SummedAreas, ExactWhereTheSizeIsNoPowerOfFour) {
    expectExactSums(128, "half");
    expectExactSums(512, "mean");
}

}  // namespace
}  // namespace penumbra
