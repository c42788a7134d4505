// Too little moment bias and too much of it.
#include <algorithm>
#include <cmath>

#include "core/curves.h"
#include "solver_rows.h"

namespace penumbra {
namespace {

// What a solver without any guard makes of moments in float32: the Cholesky decomposition and the
// roots of [Peters and Klein 2015], true where it ends in NaN or infinity.
bool unguardedFails(const vec4& b, float t) {
    const float l32d22 = b.z - b.x * b.y, d22 = b.y - b.x * b.x, variance = b.w - b.y * b.y;
    const float d33d22 = variance * d22 - l32d22 * l32d22, inverse = 1 / d22;
    const float l32 = l32d22 * inverse;
    float c0 = 1, c1 = t - b.x, c2 = t * t - b.y - l32 * c1;
    c1 *= inverse, c2 *= d22 / d33d22, c1 -= l32 * c2, c0 -= c1 * b.x + c2 * b.y;
    const float p = c1 / c2, q = c0 / c2, root = std::sqrt(p * p / 4 - q);
    return !std::isfinite(root) || !std::isfinite(p);
}

CURVE(moment_bias) {
    constexpr int kDraws = 4096;
    PlotSeries leak{.name = "leak"}, fails{.name = "NaN, no guard"};
    double guarded = 0;
    for (int exponent = -18; exponent <= -4; ++exponent) {
        const double alpha = std::pow(10, 0.5 * exponent);
        Dice dice{std::mt19937(81)};
        SolverRows shadowed;
        double failed = 0;
        for (int i = 0; i < kDraws; ++i) {
            // Two blockers and a receiver behind both: all of it is nearer.
            const Distribution two = spread(dice, 2, 0.1);
            shadowed.add(biased(two.moments(), alpha), std::min(two.depths.back() + 0.05, 1.0));
            // A lit plane, its own depth alone in the map.
            const Distribution plane = spread(dice, 1, 0.1);
            failed += unguardedFails(vec4(biased(plane.moments(), alpha)), float(plane.depths[0]));
        }
        double lit = 0;
        for (const vec4& row : shadowed.blockers("hamburger")) {
            lit += 1 - row.x;
            if (!std::isfinite(row.x)) guarded += 1;
        }
        leak.points.emplace_back(alpha, 100 * lit / kDraws);
        fails.points.emplace_back(alpha, 100 * failed / kDraws);
    }
    const auto at = [](const PlotSeries& s, double alpha) {
        return std::find_if(s.points.begin(), s.points.end(),
                            [&](const dvec2& p) { return p.x > 0.9 * alpha; })
            ->y;
    };
    EXPECT_VALUE(at(fails, 1e-9), Greater, 10,
                 "one depth: the matrix is singular but for rounding");
    EXPECT_VALUE(at(fails, 3e-5), Equal, 0,
                 "no eigenvalue below 0.168 alpha, 5e-6: eighty times the moments' rounding, 6e-8");
    EXPECT_VALUE(at(leak, 1e-2), Greater, 2 * at(leak, 1e-4),
                 "the bias is a share of light that is not there");
    EXPECT_VALUE(guarded, Equal, 0, "the guarded solver answers always");
    return {.title = "Moment bias: leaks against a singular matrix",
            .says =
                "Without bias the moments of one depth are a singular matrix, which rounding "
                "makes insoluble; with too much, blockers let light through.",
            .x = {"moment bias", true},
            .panels = {{{"share [%]"}, {leak, fails}}},
            .marks = {{3e-5, "default"}}};
}

}  // namespace
}  // namespace penumbra
