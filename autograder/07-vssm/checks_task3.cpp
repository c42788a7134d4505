// Boxes: sums by four corners, what lies beyond the border, mean and variance.
#include <fmt/format.h>

#include "variance_checks.h"

namespace penumbra {
namespace {

// The table is in float32, and the box is a difference of four of its values, each made of four
// texels: an error of 16 half ulps of the largest sum. Its edges are good to 2^-24 of the map.
double meanError(const BoxSums& sums, double width, int mapSize) {
    const double corner = std::ldexp(sums.largest(), -24), edge = std::ldexp(double(mapSize), -24);
    return 16 * corner / (width * width) + 4 * edge / width;
}

struct BoxTruth {
    Image meanVariance, interior;  // interior: boxes that keep within the map
    dvec2 error{0};
};

// From the program's own moments, in float64.
BoxTruth boxTruth(const Rendered& frame, double width, double minVariance) {
    const Image& moments = frame.at("moments");
    const double center = frame.at("center").at(0, 0), border = 1 - center;
    const int size = moments.width;
    const BoxSums first(moments, 0), second(moments, 1);
    BoxTruth truth{.meanVariance = Image(size, size, 2), .interior = Image(size, size, 1)};
    truth.error.x = meanError(first, width, size);
    truth.error.y = meanError(second, width, size) + 2 * truth.error.x;  // |mean| <= 1
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const dvec2 middle(x + 0.5, size - y - 0.5), low = middle - 0.5 * width,
                                                         high = middle + 0.5 * width;
            const dvec2 inside =
                glm::clamp(high, 0.0, double(size)) - glm::clamp(low, 0.0, double(size));
            const double area = width * width, beyond = area - inside.x * inside.y;
            const double mean = (first(low, high) + beyond * border) / area;
            const double square = (second(low, high) + beyond * border * border) / area;
            truth.meanVariance.at(x, y, 0) = float(mean + center);
            truth.meanVariance.at(x, y, 1) = float(std::max(square - mean * mean, minVariance));
            truth.interior.at(x, y) = beyond < 1e-9 ? 1 : 0;
        }
    return truth;
}

Rendered boxFrame(int mapSize, const std::string& filterWidth, const std::string& center) {
    const glm::ivec2 map(mapSize);
    return render(
        {.scene = "stairs@3",
         .size = kTiny,
         .settings = {"map_size=" + std::to_string(mapSize), "filter_width=" + filterWidth,
                      "center=" + center, "min_variance=1e-6"},
         .images = {{"mean_variance", map}, {"moments", map}, {"center", {1, 1}}}});
}

Image channel(const Image& image, int c) {
    Image one(image.width, image.height, 1);
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        one.pixels[i] = image.pixels[i * std::size_t(image.channels) + std::size_t(c)];
    return one;
}

void expectBoxes(int mapSize, double width, const std::string& center, bool interiorOnly) {
    const Rendered frame = boxFrame(mapSize, fmt::format("{}", width), center);
    const Image& mine = frame.at("mean_variance");
    const BoxTruth truth = boxTruth(frame, width, 1e-6);
    const auto [low, high] =
        std::minmax_element(truth.meanVariance.pixels.begin(), truth.meanVariance.pixels.end());
    EXPECT_VALUE(*high - *low, Greater, 0.1, "there must be something to sum: Task 1");
    const Image mask = interiorOnly ? truth.interior : Image();
    const std::string cause =
        "four corners of a float32 table: half an ulp of its largest sum each, over the area";
    EXPECT_IMAGE_NEAR(channel(mine, 0), channel(truth.meanVariance, 0),
                      {.maximum = truth.error.x, .cause = cause}, mask);
    EXPECT_IMAGE_NEAR(channel(mine, 1), channel(truth.meanVariance, 1),
                      {.maximum = truth.error.y, .cause = cause + ", of both moments"}, mask);
}

TEST(Task3Boxes, TheTableIsReadAtCornersOfTexels) {
    Dice dice{std::mt19937(34)};
    Rows inputs, truth;
    for (int i = 0; i < kRows; ++i) {
        const double size = std::exp2(std::floor(dice(0, 12)));
        const dvec2 corner =
            i % 2 == 0 ? dvec2(dice(0, size), dice(0, size)) : dvec2(0, std::floor(dice(0, size)));
        inputs.emplace_back(dvec4(corner, 1 / size, 1 / size));
        truth.emplace_back(dvec4((corner - 0.5) / size, 0, 0));
    }
    const Rows tableUv = evaluate({.chunk = "box.glsl",
                                   .expression = "vec4(tableUv(a.xy, a.zw), 0.0, 0.0)",
                                   .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(tableUv, truth, {.components = 2, .cause = kRounding});
}

TEST(Task3Boxes, FourCornersMakeAnyBoxAndPartsOfTexels) {
    expectBoxes(128, 7.3, "mean", true);
    expectBoxes(128, 1, "half", true);
}

TEST(Task3Boxes, BeyondTheBorderDepthIsOne) {
    Dice dice{std::mt19937(31)};
    Rows inputs, truth;
    for (int i = 0; i < kRows; ++i) {
        const double share = i % 8 == 0 ? 0 : i % 8 == 1 ? 1 : dice(0, 1), center = dice(0, 1);
        const dvec2 mean(dice(-1, 1), dice(0, 1)), border(1 - center, (1 - center) * (1 - center));
        inputs.emplace_back(dvec4(mean, share, center));
        truth.emplace_back(dvec4(share * mean + (1 - share) * border, 0, 0));
    }
    const Rows withBorder = evaluate({.chunk = "box.glsl",
                                      .expression = "vec4(withBorder(a.xy, a.z, a.w), 0.0, 0.0)",
                                      .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(withBorder, truth, {.absolute = 5e-7, .components = 2, .cause = kRounding});
    expectBoxes(64, 40, "mean", false);  // each box of these reaches beyond
}

TEST(Task3Boxes, VarianceIsTheMeanSquareLessTheSquaredMean) {
    Dice dice{std::mt19937(32)};
    Rows inputs, truth;
    for (int i = 0; i < kRows; ++i) {
        const double mean = dice(-0.7, 0.7), variance = dice(0.01, 0.2), center = dice(0, 1);
        inputs.emplace_back(dvec4(mean, mean * mean + variance, center, i % 2 == 0 ? 0 : 1e-4));
        truth.emplace_back(dvec4(mean + center, variance, 0, 0));
    }
    const Rows meanVariance =
        evaluate({.chunk = "box.glsl",
                  .expression = "vec4(meanVariance(a.xy, a.z, a.w), 0.0, 0.0)",
                  .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(
        meanVariance, truth,
        {.absolute = 2e-7,
         .components = 2,
         .cause = "moments up to 0.7 are rounded to 3e-8, their difference keeps that"});
}

TEST(Task3Boxes, VarianceIsNeverBelowItsFloor) {
    Dice dice{std::mt19937(33)};
    Rows inputs, truth;
    for (int i = 0; i < kRows; ++i) {
        // One depth: rounding alone decides the sign of what is left. Or less than nothing at all.
        const float mean = float(dice(-1, 1)), square = mean * mean * float(dice(0.9, 1));
        const float floor = i % 2 == 0 ? 0.0f : float(dice(1e-6, 1e-3));
        inputs.emplace_back(mean, square, dice(0, 1), floor);
        truth.emplace_back(floor, 0, 0, 0);
    }
    const Rows variance = evaluate({.chunk = "box.glsl",
                                    .expression = "vec4(meanVariance(a.xy, a.z, a.w).y)",
                                    .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(variance, truth,
                     {.absolute = 1e-7,
                      .cause = "the mean square is at most the squared mean, but for rounding"});
}

}  // namespace
}  // namespace penumbra
