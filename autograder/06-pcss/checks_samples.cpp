// Soft shadows: where samples are taken and where none are needed.
#include <algorithm>

#include "soft_checks.h"

namespace penumbra {
namespace {

// --- Task 6 ---

TEST(Task6MinPyramid, EveryTexelKnowsTheNearestOfItsWindow) {
    const std::string scene = "stairs@3";
    const Rendered frame =
        render({.scene = scene,
                .size = kSmall,
                .images = {{"min_depth", {0, 0}}, {"shadow_map", {512, 512}}, kMatrix}});
    const Image &nearest = frame.at("min_depth"), &map = frame.at("shadow_map");
    const dvec2 window =
        512.0 * MapView(frame.at("light_clip_from_world"), loadScene(scene).lights[0]).scaleUv;
    const int size = map.width / nearest.width;  // texels of the map in one of these
    const glm::ivec2 reach = size * glm::ivec2(glm::ceil(0.5 * window / double(size)));
    Image truth(nearest.width, nearest.height, 1, 1.0f);
    for (int y = 0; y < nearest.height; ++y)
        for (int x = 0; x < nearest.width; ++x)
            for (int v = std::max(size * y - reach.y, 0);
                 v < std::min(size * (y + 1) + reach.y, map.height); ++v)
                for (int u = std::max(size * x - reach.x, 0);
                     u < std::min(size * (x + 1) + reach.x, map.width); ++u)
                    truth.at(x, y) = std::min(truth.at(x, y), map.at(u, v));
    EXPECT_IMAGE_NEAR(nearest, truth,
                      {.maximum = 0, .cause = "the smallest of some depths is one of them"});
}

TEST(Task6MinPyramid, TheRadiusReachesTheWindowsEndsFromAnyPlace) {
    Dice dice{std::mt19937(61)};
    Rows rows, truth;
    while (int(truth.size()) < kRows) {
        const double texel = 1.0 / double(1 << int(dice(3, 9))), window = dice(0.01, 8) * texel;
        const double reach = 0.5 * window / texel;
        if (std::abs(reach - std::round(reach)) < 1e-3) continue;
        rows.emplace_back(dvec4(window, texel, 0, 0));
        truth.emplace_back(std::ceil(reach));
    }
    const Rows radius = evaluate({.chunk = "min_pyramid.glsl",
                                  .expression = "vec4(float(windowRadiusTexels(a.x, a.y)))",
                                  .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(radius, truth,
                     {.cause = "a whole number; no row is nearer to a step than 1e-3"});
}

TEST(Task6MinPyramid, TheNarrowedWindowHoldsEveryBlocker) {
    Dice dice{std::mt19937(62)};
    Rows widths, depths, truth;
    for (int i = 0; i < kRows; ++i) {
        const double scale = dice(0.01, 1), receiver = dice(0.1, 1);
        const double nearest = i % 4 == 0 ? receiver + dice(0, 0.2) : dice(0, receiver);
        const dvec2 s(scale, 1.5 * scale);
        const dvec2 width = s * receiver * (i % 4 == 1 ? dice(0, 1) : 1);  // narrow already
        widths.emplace_back(dvec4(width, s));
        depths.emplace_back(dvec4(receiver, nearest, 0, 0));
        truth.emplace_back(dvec4(glm::min(width, s * std::max(receiver - nearest, 0.0)), 0, 0));
    }
    const Rows narrowedWidthUv =
        evaluate({.chunk = "min_pyramid.glsl",
                  .expression = "vec4(narrowedWidthUv(a.xy, a.zw, b.x, b.y), 0.0, 0.0)",
                  .inputs = {{"a", widths}, {"b", depths}}});
    EXPECT_ROWS_NEAR(narrowedWidthUv, truth,
                     {.absolute = 1e-6,
                      .components = 2,
                      .cause = "a difference of depths that are rounded to 6e-8"});
}

// --- Task 7 ---

TEST(Task7Kernels, EverySampleHasARowAndAColumnOfItsOwn) {
    for (const int n : {3, 8}) {
        Rows cells, truth;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                cells.emplace_back(dvec4(i, j, 1.0 / n, 0));
                truth.emplace_back(dvec4(i + (j + 0.5) / n, j + (i + 0.5) / n, 0, 0) / double(n) -
                                   dvec4(0.5, 0.5, 0, 0));
            }
        const Rows shearedGrid = evaluate({.chunk = "kernels.glsl",
                                           .expression = "vec4(shearedGrid(a.xy, a.z), 0.0, 0.0)",
                                           .inputs = {{"a", cells}}});
        EXPECT_ROWS_NEAR(shearedGrid, truth, {.components = 2, .cause = kRounding});
    }
}

TEST(Task7Kernels, TheDiskKeepsAreasAndAxes) {
    Dice dice{std::mt19937(72)};
    Rows points, truth;
    const double pi = std::acos(-1.0);
    for (int i = 0; i < kRows; ++i) {
        const double axis[] = {0, dice(-0.5, 0.5)};
        const dvec2 p =
            i < 8 ? dvec2(axis[i % 2], axis[(i + 1) % 2]) : dvec2(dice(-0.5, 0.5), dice(-0.5, 0.5));
        points.emplace_back(dvec4(p, 0, 0));
        // The square through p becomes the circle of the same area; a side becomes a quarter turn.
        const double half = std::max(std::abs(p.x), std::abs(p.y)),
                     radius = 2 * half / std::sqrt(pi);
        const bool wide = std::abs(p.x) > std::abs(p.y);
        const double along = (wide ? p.y : p.x) / half * pi / 4;
        const double ahead = std::copysign(radius * std::cos(along), wide ? p.x : p.y);
        const double aside = radius * std::sin(along);
        truth.emplace_back(wide ? dvec4(ahead, aside, 0, 0) : dvec4(aside, ahead, 0, 0));
    }
    points.emplace_back(0.0f);
    truth.emplace_back(0.0f);
    const Rows diskFromSquare = evaluate({.chunk = "kernels.glsl",
                                          .expression = "vec4(diskFromSquare(a.xy), 0.0, 0.0)",
                                          .inputs = {{"a", points}}});
    EXPECT_ROWS_NEAR(diskFromSquare, truth,
                     {.absolute = 1e-4,
                      .components = 2,
                      .cause = "sine and cosine of a software rasteriser: 1e-4"});
}

}  // namespace
}  // namespace penumbra
