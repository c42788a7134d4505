// Sheets nested in each other's shadow against what eight bits and a float make of them.
#include <fmt/format.h>

#include <algorithm>

#include "core/curves.h"
#include "volume_checks.h"

namespace penumbra {
namespace {

Image counts(int sheets, const char* counter) {
    return render({.scene = fmt::format("nested@{}", sheets),
                   .size = {64, 64},
                   .settings = {"cull_range=off", "scissor=off", counter},
                   .images = {"stencil_count"}})
        .at("stencil_count");
}

CURVE(nesting) {
    PlotSeries stencil{.name = "8-bit stencil"}, floats{.name = "float"};
    double worstFloat = 0, worstStencil = 0, litByMistake = -1;
    for (const int sheets : {1, 50, 100, 150, 200, 250, 255, 256, 257, 300, 350, 400}) {
        const Image exact = counts(sheets, "counter=float"),
                    bits = counts(sheets, "counter=stencil");
        // the pixel in most shadows
        const auto deepest = std::size_t(
            std::max_element(exact.pixels.begin(), exact.pixels.end()) - exact.pixels.begin());
        const double counted = double(exact.pixels[deepest]),
                     wrapped = double(bits.pixels[deepest]);
        floats.points.emplace_back(sheets, counted);
        stencil.points.emplace_back(sheets, wrapped);
        worstFloat = std::max(worstFloat, std::abs(counted - sheets));
        worstStencil = std::max(worstStencil, std::abs(wrapped - sheets % 256));
        if (sheets == 256) litByMistake = wrapped;
    }
    EXPECT_VALUE(worstFloat, Equal, 0, "float32 counts whole numbers up to 2^24");
    EXPECT_VALUE(worstStencil, Equal, 0, "INCR_WRAP counts modulo 256");
    EXPECT_VALUE(litByMistake, Equal, 0, "256 layers of shadow are none");
    return {.title = "Count in the deepest shadow against nested sheets",
            .says = "Eight bits wrap: in 256 shadows at once a pixel counts 0 and is lit.",
            .x = {"nested sheets"},
            .panels = {{{"count"}, {stencil, floats}}},
            .marks = {{256, "256: lit"}}};
}

}  // namespace
}  // namespace penumbra
