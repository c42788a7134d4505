// How far a table of sums may grow, and an exponent.
#include <fmt/format.h>

#include "core/curves.h"
#include "variance_checks.h"

namespace penumbra {
namespace {

// Largest error of the mean over boxes of 8 x 8 texels, against float64 sums of the program's own
// moments; every box is within the map and ends at texels' edges.
double meanError(int mapSize, const std::string& prefilter, const std::string& center) {
    constexpr int kWidth = 8;
    const glm::ivec2 map(mapSize);
    const Rendered frame = render(
        {.scene = "stairs@3",
         .size = kTiny,
         .settings = {fmt::format("map_size={}", mapSize), fmt::format("filter_width={}", kWidth),
                      "prefilter=" + prefilter, "center=" + center},
         .images = {{"mean_variance", map}, {"moments", map}, {"center", {1, 1}}}});
    const Image& mine = frame.at("mean_variance");
    const BoxSums sums(frame.at("moments"), 0);
    const double subtracted = frame.at("center").at(0, 0);
    double worst = 0;
    for (int y = kWidth; y < mapSize - kWidth; y += mapSize / 64)
        for (int x = kWidth; x < mapSize - kWidth; x += mapSize / 64) {
            const dvec2 middle(x + 0.5, mapSize - y - 0.5);
            const double mean =
                sums(middle - 0.5 * kWidth, middle + 0.5 * kWidth) / kWidth / kWidth;
            worst = std::max(worst, std::abs(mine.at(x, y, 0) - mean - subtracted));
        }
    return worst;
}

CURVE(table_size) {
    struct Kind {
        const char *name, *prefilter, *center;
    };
    Curve curve{.title = "Summed-area tables: error of an 8 x 8 mean against map size",
                .says =
                    "A float's error grows with the sum that it holds; a centred one's sum is "
                    "smaller; integers modulo 2^32 lose nothing: what is left is where the box's "
                    "edges are rounded to.",
                .x = {"map size [texels]", true, {128, 256, 512, 1024, 2048}},
                .panels = {{{"largest error of the mean [depth]", true}, {}}}};
    auto& series = curve.panels[0].series;
    for (const Kind& kind :
         {Kind{"float", "sat_cpu", "zero"}, Kind{"float, centred", "sat_cpu", "mean"},
          Kind{"32-bit integer", "sat_cpu_integer", "zero"}}) {
        series.push_back({.name = kind.name});
        for (const double size : curve.x.ticks)
            series.back().points.emplace_back(size,
                                              meanError(int(size), kind.prefilter, kind.center));
    }
    const double plain = series[0].points.back().y, centred = series[1].points.back().y,
                 integer = series[2].points.back().y;
    EXPECT_VALUE(centred / plain, Less, 0.5, "at 2048² the centred table's sums are smaller");
    EXPECT_VALUE(plain / series[0].points.front().y, Greater, 16,
                 "256 times the texels: half an ulp of a sum as many times as large");
    EXPECT_VALUE(
        integer, LessOrEqual, 6.2e-5,
        "no error of the table's: a box's four edges are good to 2^-24 of 2048 texels, over "
        "a width of 8");
    return curve;
}

// A box of which half is at depth 0.5 and half at 0.9, and a receiver at 1 behind both: no light.
CURVE(exponent) {
    const std::string mean = "0.5 * (warpedMoments(0.5, a.x) + warpedMoments(0.9, a.x))";
    // -1 where one of these parts is infinite: evaluate() takes no NaN for an answer.
    const auto lit = [&](const Rows& exponents, const std::string& value, const char* part) {
        const auto lost = [&](const std::string& moments) {
            return "any(isinf((" + moments + ")." + part + "))";
        };
        return evaluate({.chunk = "exponential.glsl",
                         .expression = "vec4(" + lost(mean) + " || " +
                                       lost("warpedMoments(1.0, a.x)") + " ? -1.0 : " + value + ")",
                         .inputs = {{"a", exponents}}});
    };
    Rows exponents;
    for (int c = 5; c <= 110; c += 5) exponents.emplace_back(float(c), 0, 0, 0);
    const Rows esm = lit(exponents, "esmLit((" + mean + ").x, 1.0, a.x)", "xx"),
               evsm = lit(exponents, "evsmLit(" + mean + ", 1.0, a.x, 0.0)", "xy");
    PlotSeries one{.name = "ESM"}, two{.name = "EVSM"},
        formula{.name = "", .points = {}, .formula = true};
    double firstLost[2] = {INFINITY, INFINITY}, worst = 0;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        const double c = exponents[i].x;
        const auto shown = [&](float v, double& lost) {
            if (v >= 0) return 100 * double(v);
            lost = std::min(lost, c);
            return double(NAN);
        };
        one.points.emplace_back(c, shown(esm[i].x, firstLost[0]));
        two.points.emplace_back(c, shown(evsm[i].x, firstLost[1]));
        formula.points.emplace_back(c, 50 * (std::exp(-0.5 * c) + std::exp(-0.1 * c)));
        if (esm[i].x >= 0)
            worst = std::max(worst, std::abs(one.points.back().y / formula.points.back().y - 1));
    }
    EXPECT_VALUE(worst, LessOrEqual, 1e-4, "exp() of a software rasteriser at arguments up to 80");
    EXPECT_VALUE(firstLost[0], Equal, 90, "the largest float is exp(88.72); steps of 5");
    EXPECT_VALUE(firstLost[1], Equal, 45, "and a square reaches it at half of that, 44.36");
    return {.title = "Light that leaks through two blockers against the exponent",
            .says =
                "A larger exponent leaks less, until the largest float ends it: crosses are "
                "infinities and NaN. EVSM squares, so it ends at half the exponent.",
            .x = {"exponent c"},
            .panels = {{{"light leaked [%]", true}, {one, two, formula}}},
            .marks = {{44.36, "exp(2 c) overflows"}, {88.72, "exp(c) does"}}};
}

}  // namespace
}  // namespace penumbra
