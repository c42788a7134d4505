// What shorter steps buy, and what they cost.
#include <algorithm>

#include "core/curves.h"
#include "marches.h"

namespace penumbra {
namespace {

CURVE(step_cap) {
    PlotSeries worst{.name = "largest error"},
        allowed{.name = "cap² / 8", .points = {}, .formula = true}, steps{.name = "look-ups"};
    double over = 0;
    for (const double cap : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
        const SphereMarches spheres(24, {cap});
        const Rows found = marched(spheres.marches);
        double high = 0, lookUps = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            high = std::max(high, std::abs(double(found[i].x) / double(spheres.truth[i].x) - 1));
            lookUps += found[i].z;
        }
        worst.points.emplace_back(cap, high);
        allowed.points.emplace_back(cap, cap * cap / 8);
        steps.points.emplace_back(cap, lookUps / double(found.size()));
        over = std::max(over, high / (cap * cap / 8));
    }
    EXPECT_VALUE(over, LessOrEqual, 1,
                 "a look-up is at most half a step, cap · distance / 2, beside the least place, "
                 "around which distance / t curves like 1 / distance");
    const double tenTimesTheCap = worst.points[5].y / worst.points[2].y;  // 0.5 and 0.05
    EXPECT_VALUE(tenTimesTheCap, Greater, 50,
                 "100 for the square of the cap; where look-ups fall is worth a factor below 2");
    return {
        .title = "A sphere's least distance / t against the step cap",
        .says = "The error falls with the square of the cap, the look-ups grow with its inverse.",
        .x = {"step cap [of the distance]", true},
        .panels = {{{"relative error", true}, {worst, allowed}},
                   {{"look-ups of a ray", true}, {steps}}}};
}

}  // namespace
}  // namespace penumbra
