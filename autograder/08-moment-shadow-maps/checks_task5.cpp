// Task 5: Hausdorff's problem: the same, where all depths are known to lie in [-1,1].
#include <algorithm>
#include <cmath>

#include "solver_rows.h"

namespace penumbra {
namespace {

// For given moments and t there is either a distribution of three depths inside, Hamburger's, or
// one of -1, t, x and 1; never both.
TEST(Task5Hausdorff, ThreeDepthsInsideOrFourWithTheEndsAreExact) {
    Dice dice{std::mt19937(51)};
    SolverRows rows;
    Rows truth;
    for (int i = 0; i < kRows; ++i) {
        Distribution d = i % 4 == 0 ? spread(dice, 3, 0.25) : spread(dice, 2, 0.25, true);
        const double t = d.depths[std::size_t(i % 4 == 0 ? i / 4 % 3 : i % 2)];
        if (i % 4 != 0) {
            d.depths.insert(d.depths.end(), {-1, 1});
            d.shares = randomShares(dice, 4, 0.1);
        }
        const Below below = d.below(t);
        rows.add(d.moments(), t);
        truth.emplace_back(dvec4(below.share, below.depth(), 0, 0));
    }
    EXPECT_ROWS_NEAR(rows.blockers("hausdorff"), truth, kThreePoints);
}

const std::string kCause =
    "1 is twice what rounding costs in Hamburger's problem, or 1e-6 over the distance of t to "
    "-1 or 1";

TEST(Task5Hausdorff, AtLeastHamburgersShareAndNeverMoreThanTheTrueOne) {
    Dice dice{std::mt19937(53)};
    SolverRows rows;
    std::vector<double> allowed;
    std::vector<Below> truth;
    for (int i = 0; i < kRows; ++i) {
        const double alpha = std::pow(10, -2 - i % 3 * 0.75);
        const Distribution d = biased(randomDistribution(dice), alpha);
        rows.add(d.moments(), i % 5 == 0 ? d.depths[0] : dice(-1, 1));
        truth.push_back(d.below(rows.t(i)));
        // Neighbours' shares are told apart by their distance: t's and the end's after some ten
        // roundings, t's and x's at twice what Hamburger's problem costs.
        const double apart = std::max(1 - std::abs(rows.t(i)), 1e-7);
        allowed.push_back(std::max(2 * shareRounding(alpha), 16 * 6e-8 / apart));
    }
    const Rows blockers = rows.blockers("hausdorff");
    double missing = 0, gain = 0;
    for (int i = 0; i < kRows; ++i) {
        const double more =
            blockers[std::size_t(i)].x - threePoints(rows.moments(i), rows.t(i)).below.share;
        missing = std::max(missing, -more / allowed[std::size_t(i)]);
        gain = std::max(gain, more);
    }
    EXPECT_VALUE(mostOver(blockers, truth, allowed), LessOrEqual, 1,
                 "false shadow: more than can be nearer. " + kCause);
    EXPECT_VALUE(missing, LessOrEqual, 1, "who knows more, knows a better bound. " + kCause);
    EXPECT_VALUE(gain, Greater, 0.1, "and a much better one where many depths lie at the ends");
}

TEST(Task5Hausdorff, FiniteAndAShareForAnyMoments) {
    expectShares(anyMoments(54).blockers("hausdorff"), anyMoments(54));
}

}  // namespace
}  // namespace penumbra
