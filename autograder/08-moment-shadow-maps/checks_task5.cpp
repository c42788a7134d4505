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
        const double t = d.depths[std::size_t(i % 3 % 2)];
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
        // The shares of t and of the end beside it are told apart by their distance, after some ten
        // roundings.
        const double apart = std::max(1 - std::abs(rows.t(i)), 1e-7);
        allowed.push_back(std::max(shareRounding(alpha), 16 * 6e-8 / apart));
    }
    const Rows blockers = rows.blockers("hausdorff");
    double short_ = 0, gain = 0;
    for (int i = 0; i < kRows; ++i) {
        const double more =
            blockers[std::size_t(i)].x - threePoints(rows.moments(i), rows.t(i)).below.share;
        short_ = std::max(short_, -more / allowed[std::size_t(i)]);
        gain = std::max(gain, more);
    }
    EXPECT_VALUE(mostOver(blockers, truth, allowed), LessOrEqual, 1,
                 "false shadow: more than can be nearer. " + kShareCause);
    EXPECT_VALUE(short_, LessOrEqual, 1, "who knows more, knows a better bound. " + kShareCause);
    EXPECT_VALUE(gain, Greater, 0.1, "and a much better one where many depths lie at the ends");
}

TEST(Task5Hausdorff, FiniteAndAShareForAnyMoments) {
    expectShares(anyMoments(54).blockers("hausdorff"), anyMoments(54));
}

}  // namespace
}  // namespace penumbra
