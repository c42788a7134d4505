// Moments: of one depth by formula, of a map by its own depths.
#include "variance_checks.h"

namespace penumbra {
namespace {

TEST(Task1Moments, DistanceFromTheCenterAndItsSquare) {
    Dice dice{std::mt19937(11)};
    Rows inputs, truth;
    for (int i = 0; i < kRows; ++i) {
        const float depth = i % 8 == 0 ? 0.0f : i % 8 == 1 ? 1.0f : float(dice(0, 1));
        const float center = i % 3 == 0 ? 0.0f : i % 3 == 1 ? 0.5f : float(dice(0, 1));
        const double d = double(depth) - double(center);
        inputs.emplace_back(depth, center, 0, 0);
        truth.emplace_back(dvec4(d, d * d, 0, 0));
    }
    const Rows momentsFromDepth =
        evaluate({.chunk = "moments.glsl",
                  .expression = "vec4(momentsFromDepth(a.x, a.y), 0.0, 0.0)",
                  .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(momentsFromDepth, truth,
                     {.absolute = 2e-7,
                      .components = 2,
                      .cause = "a difference of depths up to 1, rounded to 6e-8, and its square"});
}

TEST(Task1Moments, EveryTexelOfTheMapHasItsOwn) {
    constexpr int kMap = 128;
    const Rendered frame = render(
        {.scene = "stairs@3",
         .size = kTiny,
         .settings = {"map_size=128", "prefilter=mipmap"},
         .images = {{"moments", {kMap, kMap}}, {"shadow_map", {kMap, kMap}}, {"center", {1, 1}}}});
    const double center = frame.at("center").at(0, 0);
    const Image& map = frame.at("shadow_map");
    Image truth(kMap, kMap, 2);
    for (int y = 0; y < kMap; ++y)
        for (int x = 0; x < kMap; ++x) {
            const double d = map.at(x, y) - center;
            truth.at(x, y, 0) = float(d), truth.at(x, y, 1) = float(d * d);
        }
    EXPECT_IMAGE_NEAR(frame.at("moments"), truth,
                      {.maximum = 2e-7, .cause = "the map's own depths, float32"});
}

}  // namespace
}  // namespace penumbra
