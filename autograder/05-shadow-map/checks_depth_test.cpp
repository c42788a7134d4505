// Shadow maps: the comparison and its filter, what lies outside of the map, and second depths.
#include "core/metrics.h"
#include "map_checks.h"

namespace penumbra {
namespace {

// --- Task 3 ---

TEST(Task3DepthTest, NearerReceiversAreLitAndFartherOnesDark) {
    Dice dice{std::mt19937(31)};
    const Rows depths = makeRows(kRows, [&] { return dvec4(dice(0, 1), dice(0, 1), 0, 0); });
    Rows truth;
    for (const vec4 d : depths) truth.emplace_back(d.y <= d.x ? 1 : 0);
    const Rows litBy = evaluate({.chunk = "depth_test.glsl",
                                 .expression = "vec4(litBy(a.x, a.y))",
                                 .inputs = {{"a", depths}}});
    EXPECT_ROWS_NEAR(litBy, truth, {.cause = "a comparison has no error"});
}

TEST(Task3DepthTest, EqualDepthsAreLit) {
    Dice dice{std::mt19937(32)};
    const Rows depths = makeRows(kRows, [&] { return dvec4(dice(0, 1)); });
    const Rows litByEqualDepths = evaluate({.chunk = "depth_test.glsl",
                                            .expression = "vec4(litBy(a.x, a.x))",
                                            .inputs = {{"a", depths}}});
    EXPECT_ROWS_NEAR(litByEqualDepths, Rows(kRows, vec4(1.0f)),
                     {.cause = "the surface that the map shows is itself lit"});
}

TEST(Task3DepthTest, Filter2x2WeighsComparisonsBilinearly) {
    Dice dice{std::mt19937(33)};
    const auto random = [&] { return dvec4(dice(0, 1), dice(0, 1), dice(0, 1), dice(0, 1)); };
    const Rows stored = makeRows(kRows, random), receiver = makeRows(kRows, random),
               fraction = makeRows(kRows, random);
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const dvec2 f = dvec2(fraction[i]);
        dvec4 lit;
        for (int k = 0; k < 4; ++k) lit[k] = receiver[i][k] <= stored[i][k];
        truth.emplace_back(glm::mix(glm::mix(lit.x, lit.y, f.x), glm::mix(lit.z, lit.w, f.x), f.y));
    }
    const Rows filter2x2 = evaluate({.chunk = "depth_test.glsl",
                                     .expression = "vec4(filter2x2(a, b, c.xy))",
                                     .inputs = {{"a", stored}, {"b", receiver}, {"c", fraction}}});
    EXPECT_ROWS_NEAR(filter2x2, truth, {.cause = kRounding});
}

TEST(Task3DepthTest, NeverAveragesDepths) {
    // A vertical step: near on the left, far on the right, the receiver between. The mean of the
    // depths would switch from dark to light at once; the mean of the comparisons grows with the
    // distance.
    Rows fraction, truth;
    for (int i = 0; i < kRows; ++i) {
        fraction.emplace_back(vec4(float(i) / (kRows - 1)));
        truth.emplace_back(vec4(float(i) / (kRows - 1)));
    }
    const Rows filter2x2AcrossAStep =
        evaluate({.chunk = "depth_test.glsl",
                  .expression = "vec4(filter2x2(vec4(0.2, 0.9, 0.2, 0.9), vec4(0.5), a.xy))",
                  .inputs = {{"a", fraction}}});
    EXPECT_ROWS_NEAR(filter2x2AcrossAStep, truth, {.cause = kRounding});
}

// --- Task 5 ---

Rows askOutside(const Rows& lightClip) {
    return evaluate({.chunk = "outside_map.glsl",
                     .expression = "vec4(visibilityOutsideMap(a))",
                     .inputs = {{"a", lightClip}}});
}

TEST(Task5OutsideMap, BehindTheLightIsDark) {
    Dice dice{std::mt19937(51)};
    Rows clip =
        makeRows(kRows, [&] { return dvec4(dice(-9, 9), dice(-9, 9), dice(-9, 9), dice(-9, 0)); });
    clip.push_back({1.0f, 1.0f, 1.0f, 0.0f});
    const Rows visibilityOutsideMap = askOutside(clip);
    EXPECT_ROWS_NEAR(visibilityOutsideMap, Rows(clip.size(), vec4(0.0f)),
                     {.cause = "the light shines to the side where w > 0"});
}

TEST(Task5OutsideMap, BesideTheMapAndBeforeTheNearPlaneIsLit) {
    Dice dice{std::mt19937(52)};
    Rows clip;
    for (int i = 0; i < kRows; ++i) {
        const double w = dice(0.1, 9), sign = i % 2 ? 1 : -1, beyond = sign * w * dice(1.01, 3);
        const double u = dice(-w, w), v = dice(-w, w);
        clip.emplace_back(i % 3 == 0   ? dvec4(beyond, u, v, w)
                          : i % 3 == 1 ? dvec4(u, beyond, v, w)
                                       : dvec4(u, v, -w * dice(1.01, 3), w));
    }
    const Rows visibilityOutsideMap = askOutside(clip);
    EXPECT_ROWS_NEAR(visibilityOutsideMap, Rows(clip.size(), vec4(1.0f)),
                     {.cause = "where the map knows of no blocker there is light"});
}

TEST(Task5OutsideMap, InsideAndPastTheFarPlaneTheMapIsAsked) {
    Dice dice{std::mt19937(53)};
    const Rows clip = makeRows(kRows, [&] {
        const double w = dice(0.1, 9);
        return dvec4(dice(-w, w) * 0.99, dice(-w, w) * 0.99, w * dice(-0.99, 3), w);
    });
    const Rows visibilityOutsideMap = askOutside(clip);
    EXPECT_ROWS_NEAR(visibilityOutsideMap, Rows(clip.size(), vec4(-1.0f)), {.cause = "kInsideMap"});
}

TEST(Task5OutsideMap, NoMirroredShadowBehindTheLight) {
    const Scene scene = lowLight();
    const Light& light = scene.lights[0];
    const TracedScene truth(scene, kSmall);
    const Receivers& receivers = truth.receivers();
    const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall});
    Image behind(kSmall.x, kSmall.y, 1);
    for (std::size_t i = 0; i < behind.pixels.size(); ++i)
        behind.pixels[i] = receivers.hit[i] && glm::dot(receivers.positions[i] - light.center,
                                                        light.forward()) < -0.05f;
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth.pointVisibility(),
        {.maximum = 0, .cause = "every receiver at least 0.05 behind the light's plane is dark"},
        behind);
}

// --- Task 6 ---

TEST(Task6SecondDepth, PeelsTheFirstSurfaceAndNothingElse) {
    Dice dice{std::mt19937(61)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const double first = dice(0.1, 0.9), step = i % 2 ? 1.0 / 65535 : 0.0;
        const double ahead = i % 4 < 2 ? dice(-0.5, 0.5) * step : 2 * step + dice(1e-4, 0.1);
        rows.emplace_back(dvec4(first + ahead, first, step, 0));
        truth.emplace_back(i % 4 < 2 ? 1 : 0);
    }
    const Rows isFirstSurface =
        evaluate({.chunk = "second_depth.glsl",
                  .expression = "vec4(isFirstSurface(a.x, a.y, a.z) ? 1.0 : 0.0)",
                  .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(isFirstSurface, truth,
                     {.cause = "a comparison has no error; depths differ by at most half a step, "
                               "or by at least two"});
}

TEST(Task6SecondDepth, ThresholdIsMidway) {
    Dice dice{std::mt19937(62)};
    const Rows rows = makeRows(kRows, [&] { return dvec4(dice(0, 0.5), dice(0.5, 1), 0, 0); });
    Rows truth;
    for (const vec4 r : rows) truth.emplace_back(0.5 * (double(r.x) + r.y));
    const Rows midpointDepth = evaluate({.chunk = "second_depth.glsl",
                                         .expression = "vec4(midpointDepth(a.x, a.y))",
                                         .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(midpointDepth, truth, {.cause = kRounding});
}

TEST(Task6SecondDepth, NoBiasIsNeededForClosedBlockers) {
    const TracedScene truth(loadScene("stairs@2"), kSmall);
    for (const char* format : {"depth_format=32f", "depth_format=16"}) {
        const Rendered frame =
            render({.scene = "stairs@2",
                    .size = kSmall,
                    .settings = {"second_depth=on", "receiver_plane=off", "filter=off", format},
                    .images = {"visibility", kMatrix}});
        const Image inside = interior(truth, frame.at("light_clip_from_world"), 1024, 2.0f);
        const Metrics m =
            compareVisibility(frame.at("visibility"), truth.pointVisibility(), &inside);
        EXPECT_VALUE(m.falseShadowRate, LessOrEqual, 0.001,
                     std::string(format) +
                         ": the threshold lies inside the blocker; only edges thinner than a texel "
                         "of depth remain");
        EXPECT_VALUE(m.lightLeakRate, LessOrEqual, 0.001,
                     std::string(format) + ": and nothing is lit behind it");
    }
}

}  // namespace
}  // namespace penumbra
