// Task 4: blockers in the search window, a filter as wide as the penumbra, and the receiver's plane.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/metrics.h"
#include "core/truths.h"
#include "soft_frames.h"
#include "truth/closed_form.h"

namespace penumbra {
namespace {

using glm::vec3;
constexpr glm::ivec2 kSmall{256, 256};

TEST(Task4SoftShadow, ComparesBelowTheReceiversPlane) {
    Dice dice{std::mt19937(41)};
    Rows depths, heights, lights, truth;
    while (int(truth.size()) < 1000) {
        const double receiver = dice(0.05, 1), blocker = receiver * dice(0, 1.1);
        const double bias = dice(0, 0.02);
        const dvec3 height(dice(-0.2, 2), dice(-1, 1), dice(-1, 1));
        const dvec2 low(dice(-0.5, 0.5), dice(-0.5, 0.5));
        const dvec4 light(low, dice(low.x, 0.5), dice(low.y, 0.5));
        const double fall = planeFall(height, {light.x, light.y}, {light.z, light.w});
        if (std::abs(height.x) < 1e-3) continue;  // its sign decides
        depths.emplace_back(dvec4(receiver, blocker, bias, 0));
        heights.emplace_back(dvec4(height, 0));
        lights.emplace_back(light);
        truth.emplace_back(
            float(receiver - bias - 0.75 * fall * std::max(receiver - blocker, 0.0)));
    }
    const Rows comparedDepth =
        evaluate({.chunk = "receiver_plane.glsl",
                  .expression =
                      "vec4(comparedDepth(Receiver(vec3(0.5, 0.5, a.x), b.xyz, c, 1.0, a.z), a.y))",
                  .inputs = {{"a", depths}, {"b", heights}, {"c", lights}}});
    EXPECT_ROWS_NEAR(comparedDepth, truth,
                     {.absolute = 2e-6,
                      .cause = "depths are rounded to 6e-8, a quotient and a few sums follow"});
}

// Receivers before the light, where `truth` has a value.
template <typename Truth>
void compareWithTwin(const Image& mine, const Rendered& frame, Truth&& truth) {
    const Image& receivers = frame.at("receiver");
    Image expected(mine.width, mine.height, 1), mask(mine.width, mine.height, 1);
    for (int y = 0; y < mine.height; ++y)
        for (int x = 0; x < mine.width; ++x) {
            if (receivers.at(x, y, 3) <= 0) continue;
            const auto value = truth(
                x, y, dvec3(receivers.at(x, y, 0), receivers.at(x, y, 1), receivers.at(x, y, 2)));
            if (!value) continue;
            expected.at(x, y) = float(*value), mask.at(x, y) = 1;
        }
    EXPECT_IMAGE_NEAR(mine, expected,
                      {.maximum = 1e-3,
                       .cause = "the same map in float64; sums in integers round moments to 1e-5, "
                                "and a bias of 1e-2 makes at most a hundred times as much of that"},
                      mask);
}

using Maybe = std::optional<double>;
constexpr double kLeastShare = 0.001;  // fewer blockers than that are none
constexpr double kSure = 1e-4;         // so far from that border it is no matter of rounding
constexpr double kEnough = 0.05;       // to divide by

TEST(Task4SoftShadow, TheSearchWindowHoldsAllThatCanBlock) {
    const Rendered frame = searchFrame(0);
    const MapTwin map(frame);
    compareWithTwin(frame.at("blocker_share"), frame, [&](int, int, dvec3 p) {
        const double share = map.search(p, 0).share;
        return std::abs(share - kLeastShare) > kSure ? Maybe(share < kLeastShare ? 0 : share)
                                                     : Maybe();
    });
    compareWithTwin(frame.at("blocker_depth"), frame, [&](int, int, dvec3 p) {
        const Below below = map.search(p, 0);
        return below.share > kEnough ? Maybe(below.depth()) : Maybe();
    });
}

TEST(Task4SoftShadow, FewerThanTheLeastShareAreNone) {
    const Rendered frame =
        render({.scene = "stairs@3", .size = {128, 128}, .images = {"blocker_share"}});
    double least = 1;
    for (const float share : frame.at("blocker_share").pixels)
        if (share > 0) least = std::min(least, double(share));
    EXPECT_VALUE(least, Less, 1, "there must be blockers");
    EXPECT_VALUE(least, GreaterOrEqual, float(kLeastShare), "README §4: below it there is nothing");
}

TEST(Task4SoftShadow, ARefinementLooksThroughTheFirstBlockers) {
    for (const int refinements : {1, 2}) {
        // The receiver's plane is no matter of the search's.
        const Rendered first = searchFrame(refinements - 1, 1, true),
                       frame = searchFrame(refinements, 1, true);
        const MapTwin map(frame);
        compareWithTwin(frame.at("blocker_depth"), frame, [&](int x, int y, dvec3 p) {
            const bool found = first.at("blocker_share").at(x, y) > kEnough;
            const Below below = map.search(p, first.at("blocker_depth").at(x, y));
            return found && below.share > kEnough ? Maybe(below.depth()) : Maybe();
        });
    }
}

TEST(Task4SoftShadow, TheFilterIsAsWideAsThePenumbra) {
    for (const int cells : {1, 2}) {
        const Rendered frame = searchFrame(0, cells);
        const MapTwin map(frame);
        compareWithTwin(frame.at("visibility"), frame, [&](int x, int y, dvec3 p) {
            const float depth = frame.at("blocker_depth").at(x, y);
            const bool found = frame.at("blocker_share").at(x, y) > 0;
            return Maybe(found ? map.filteredVisibility(p, depth, cells) : 1);
        });
    }
}

TEST(Task4SoftShadow, EachCellIsComparedBelowItsPartOfThePlane) {
    constexpr int kCells = 3;  // the whole of some lies uphill of the receiver
    const Rendered frame = searchFrame(0, kCells, true);
    const MapTwin map(frame);
    const Image& heights = frame.at("light_height");
    compareWithTwin(frame.at("visibility"), frame, [&](int x, int y, dvec3 p) {
        const float depth = frame.at("blocker_depth").at(x, y);
        const dvec3 height(heights.at(x, y, 0), heights.at(x, y, 1), heights.at(x, y, 2));
        const bool found = frame.at("blocker_share").at(x, y) > 0;
        return Maybe(found ? map.filteredVisibility(p, depth, kCells, height) : 1);
    });
}

TEST(Task4SoftShadow, AHalfPlanesPenumbraIsALinearRamp) {
    const TracedScene traced(loadScene("halfplane"), kSmall);
    const Receivers& receivers = traced.receivers();
    const Rendered frame = render({.scene = "halfplane", .size = kSmall});
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
        const vec3 p = receivers.positions[i];
        if (!receivers.hit[i] || p.y > 0.01f) continue;
        const double error = frame.at("visibility").pixels[i] -
                             halfPlaneVisibility(p.x, kHalfPlaneBlockerHeight,
                                                 kHalfPlaneLightHeight, kHalfPlaneLightWidth);
        sum += error * error, count += 1;
    }
    EXPECT_VALUE(std::sqrt(sum / count), LessOrEqual, 0.004,
                 "two depths: what is left is the moment bias and the map's texel");
}

TEST(Task4SoftShadow, WithoutABlockerOnlyTheHorizonCutsTheLight) {
    for (const Scene& scene : {bareGround(), loadScene("tilted@85"), settingLight()}) {
        const TracedScene traced(scene, kSmall);
        const Receivers& receivers = traced.receivers();
        Image truth(kSmall.x, kSmall.y, 1, 1.0f);
        for (std::size_t i = 0; i < truth.pixels.size(); ++i)
            if (receivers.hit[i])
                truth.pixels[i] = float(horizonVisibility(
                    receivers.positions[i], receivers.facetNormals[i], scene.lights[0]));
        const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall});
        EXPECT_IMAGE_NEAR(
            frame.at("visibility"), truth,
            {.maximum = 0.02,
             .cause = scene.name + ": nothing stands before this plane, and its share "
                                   "of the light is a closed form"});
    }
}

TEST(Task4SoftShadow, ScalingTheWorldChangesNothing) {
    const Scene scene = loadScene("stairs@4");
    const Rendered one = render({.scene = sceneFile(scene), .size = kSmall});
    const auto& pixels = one.at("visibility").pixels;
    const auto dark = std::count_if(pixels.begin(), pixels.end(), [](float v) { return v < 0.5f; });
    EXPECT_VALUE(dark, Greater, 0.05 * double(pixels.size()), "this scene is full of shadows");
    for (const float scale : {16.0f, 0.0625f}) {
        const Rendered other = render({.scene = sceneFile(scaled(scene, scale)), .size = kSmall});
        EXPECT_IMAGE_NEAR(other.at("visibility"), one.at("visibility"),
                          {.maximum = 1e-6, .cause = "a power of two changes no digit of a float"});
    }
}

TEST(Task4SoftShadow, ATinyLightCastsAHardShadowAndAHugeOneStaysFinite) {
    const Image hard = TracedScene(loadScene("boxes@4"), kSmall).pointVisibility();
    const Rendered tiny =
        render({.scene = "boxes@4", .size = kSmall, .settings = {"light_size=0.001"}});
    EXPECT_VALUE(compareVisibility(tiny.at("visibility"), hard).rmse, LessOrEqual, 0.05,
                 "one texel along every edge, as for a hard shadow map of 512 texels");
    const Rendered huge =
        render({.scene = "boxes@4", .size = kSmall, .settings = {"light_size=4"}});
    const auto& pixels = huge.at("visibility").pixels;
    const auto [low, high] = std::minmax_element(pixels.begin(), pixels.end());
    EXPECT_VALUE(*low, GreaterOrEqual, 0, "a share");
    EXPECT_VALUE(*high, LessOrEqual, 1, "a share");
}

}  // namespace
}  // namespace penumbra
