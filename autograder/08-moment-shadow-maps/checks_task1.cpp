// Task 1: four moments of a depth.
#include "moment_checks.h"
#include "soft_frames.h"

namespace penumbra {
namespace {

vec4 momentsOf(double depth) {
    const double z = 2 * depth - 1;
    return dvec4(z, z * z, z * z * z, z * z * z * z);
}

Rows depthMoments(const Rows& depths) {
    return evaluate(
        {.chunk = "moments.glsl", .expression = "depthMoments(a.x)", .inputs = {{"a", depths}}});
}

TEST(Task1Moments, TheyArePowersOfADepthFromMinusOneToOne) {
    Dice dice{std::mt19937(11)};
    Rows depths{vec4(0.0f), vec4(0.5f), vec4(1.0f)};
    for (int i = 0; i < 500; ++i) depths.emplace_back(float(dice(0, 1)));
    Rows truth;
    for (const vec4& depth : depths) truth.push_back(momentsOf(depth.x));
    EXPECT_ROWS_NEAR(depthMoments(depths), truth,
                     {.absolute = 5e-7,
                      .components = 4,
                      .cause = "2 d - 1 is rounded to 6e-8, and three products follow"});
}

TEST(Task1Moments, DepthsOutsideCountAsTheNearestInside) {
    Dice dice{std::mt19937(12)};
    Rows depths, truth;
    for (int i = 0; i < 100; ++i) {
        depths.emplace_back(float(i % 2 ? dice(-2, 0) : dice(1, 3)));
        truth.push_back(momentsOf(i % 2 ? 0 : 1));
    }
    EXPECT_ROWS_NEAR(depthMoments(depths), truth,
                     {.components = 4, .cause = "powers of -1 and 1 are exact"});
}

TEST(Task1Moments, EveryTexelHoldsThoseOfItsDepth) {
    const Rendered frame = searchFrame(0);
    const Image &depths = frame.at("shadow_map"), &moments = frame.at("moments");
    Image truth(depths.width, depths.height, 4);
    for (int y = 0; y < depths.height; ++y)
        for (int x = 0; x < depths.width; ++x)
            for (int c = 0; c < 4; ++c) truth.at(x, y, c) = momentsOf(depths.at(x, y))[c];
    EXPECT_IMAGE_NEAR(moments, truth,
                      {.maximum = 5e-7, .cause = "storage=float32 keeps what the function gives"});
}

}  // namespace
}  // namespace penumbra
