// Soft shadows: whole pictures against rays, and backprojection.
#include "core/metrics.h"
#include "soft_checks.h"

namespace penumbra {
namespace {

// --- Task 8 and the bonus ---

void compareWithRays(const std::string& name, glm::ivec2 size,
                     const std::vector<std::string>& settings, double bound, double leak) {
    const Image truth = TracedScene(loadScene(name), size).areaVisibility(144);
    const Rendered frame = render({.scene = name, .size = size, .settings = settings});
    const Metrics m = compareVisibility(frame.at("visibility"), truth);
    EXPECT_VALUE(m.rmse, LessOrEqual, bound,
                 name + ": one blocker depth stands for all, one texel for what it holds");
    if (leak < 1)
        EXPECT_VALUE(
            m.lightLeakRate, LessOrEqual, leak,
            name + ": the share of the umbra's pixels that got more than a tenth of light");
}

constexpr glm::ivec2 kLarge{512, 512};

TEST(Task8WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@5", kLarge, {}, 0.022, 0.02); }
TEST(Task8WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@5", kLarge, {}, 0.084, 1); }
TEST(Task8WholeShadow, FoliageAgreesWithRays) {
    compareWithRays("foliage@5", kLarge, {}, 0.097, 1);
}
TEST(Task8WholeShadow, StairsAgreeWithRays) {
    compareWithRays("stairs@5", kLarge, {}, 0.034, 0.04);
}

// What the blocking cells hide of the light, each depth of the program's own map standing for a
// cell: an area of the square [-1/2, 1/2]².
double hiddenArea(const Map& map, vec2 uv, double depth, double bias, dvec2 scaleUv, dvec2 cell,
                  int n) {
    double hidden = 0;
    visitGrid(uv, vec2(double(n) * cell), n, [&](vec2 place) {
        const double nearer = depth - map(place);
        if (nearer <= bias) return;
        const dvec2 light = 1.0 / (scaleUv * nearer);
        const dvec2 middle = dvec2(place - uv) * light, half = 0.5 * cell * light;
        const dvec2 sides =
            glm::clamp(middle + half, -0.5, 0.5) - glm::clamp(middle - half, -0.5, 0.5);
        hidden += sides.x * sides.y;
    });
    return hidden;
}

TEST(Task9Backprojection, EachCellHidesItsRectangle) {
    constexpr int kCells = 8;
    const std::string scene = "stairs@3";
    const Rendered frame =
        render({.scene = scene,
                .size = kSmall,
                .settings = {"method=backprojection", "receiver_plane=off", "filter_samples=8"},
                .images = {"visibility",
                           "search",
                           "receiver",
                           "light_height",
                           {"shadow_map", {512, 512}},
                           kMatrix}});
    const MapView view(frame.at("light_clip_from_world"), loadScene(scene).lights[0]);
    const Map map{frame.at("shadow_map")};
    const Image &receivers = frame.at("receiver"), &heights = frame.at("light_height"),
                &search = frame.at("search");
    Image truth(kSmall.x, kSmall.y, 1), mask(kSmall.x, kSmall.y, 1);
    for (int y = 0; y < kSmall.y; ++y)
        for (int x = 0; x < kSmall.x; ++x) {
            const float lowest = heights.at(x, y, 0) - 0.5f * (std::abs(heights.at(x, y, 1)) +
                                                               std::abs(heights.at(x, y, 2)));
            if (receivers.at(x, y, 3) <= 0 || lowest <= 0) continue;
            mask.at(x, y) = 1;
            const vec2 uv(receivers.at(x, y, 0), receivers.at(x, y, 1));
            const double depth = receivers.at(x, y, 2);
            const dvec2 window = view.scaleUv * dvec2(search.at(x, y, 0), search.at(x, y, 1));
            const dvec2 cell = glm::max(window / double(kCells), dvec2(1.0 / 512));
            const double hidden =
                hiddenArea(map, uv, depth, view.bias(depth, 512), view.scaleUv, cell, kCells);
            truth.at(x, y) = float(std::max(1 - hidden, 0.0));
        }
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth,
        {.outliers = 0.002,
         .outlierDistance = 0.01,
         .cause =
             "your own search, the same cells of the same map; where two texels differ, a cell's "
             "centre within rounding of their border, 3e-5 texels, may take either: 0.4 % of the "
             "pixels have such a cell, and fewer than half of them an edge there"},
        mask);
}

TEST(Task9Backprojection, FenceAndStairsAgreeWithRays) {
    const std::vector<std::string> settings{"method=backprojection", "filter_samples=16"};
    compareWithRays("fence@5", kSmall, settings, 0.050, 1);
    compareWithRays("stairs@5", kSmall, settings, 0.040, 1);
}

TEST(Task9Backprojection, AHalfPlaneHidesALinearShare) {
    EXPECT_VALUE(halfPlaneError(4, 16, {"method=backprojection"}), LessOrEqual, 0.019,
                 "cells are at most a sixteenth of the light wide, and the edge cuts one of them: "
                 "1/16/√12 = 0.018 at worst, less where a cell is a texel");
}

TEST(Task9Backprojection, TheHorizonIsAClosedForm) {
    expectHorizonOnly(loadScene("tilted@85"), {"method=backprojection"});
    expectHorizonOnly(settingLight(), {"method=backprojection"});
}

}  // namespace
}  // namespace penumbra
