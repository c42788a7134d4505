// Task 3: Hamburger's problem: at least how much is nearer than t?
#include <algorithm>
#include <cmath>

#include "moment_checks.h"
#include "solver_rows.h"

namespace penumbra {
namespace {

// Any moments and any t have such a distribution: so this is every case, solved without a solver.
TEST(Task3Hamburger, TheOtherDepthsCompleteThreePoints) {
    Dice dice{std::mt19937(31)};
    SolverRows rows;
    Rows truth;
    // As far on one side of t as on the other: the factor of z is 0, and has no sign.
    for (const double z : {1.0, 0.5, 0.25}) {
        rows.add(Distribution{{-z, 0, z}, {0.25, 0.5, 0.25}}.moments(), 0);
        truth.emplace_back(dvec4(-z, z, 0, 0));
    }
    for (int i = 0; int(rows.size()) < kRows; ++i) {
        const Distribution d = spread(dice, 3, 0.25);
        const int at = i % 3;
        rows.add(d.moments(), d.depths[std::size_t(at)]);
        truth.emplace_back(dvec4(d.depths[at == 0], d.depths[at == 2 ? 1 : 2], 0, 0));
    }
    const Rows otherDepths = rows.evaluate("hamburger.glsl", "vec4(otherDepths(a, b.x), 0.0, 0.0)");
    EXPECT_ROWS_NEAR(otherDepths, truth, kThreePoints);
}

TEST(Task3Hamburger, SharesAndDepthsOfThreePointsAreExact) {
    Dice dice{std::mt19937(32)};
    SolverRows rows;
    Rows truth;
    for (int i = 0; i < kRows; ++i) {
        const Distribution d = spread(dice, 3, 0.25);
        const double t = d.depths[std::size_t(i % 3)];
        const Below below = d.below(t);
        rows.add(d.moments(), t);
        truth.emplace_back(dvec4(below.share, below.depth(), 0, 0));
    }
    EXPECT_ROWS_NEAR(rows.blockers("hamburger"), truth, kThreePoints);
}

// Where t is one of the two points that a distribution of two would have, the third is infinitely
// far away, and its weight 0: what is left of the shares must not suffer.
TEST(Task3Hamburger, ANearPointIsRightThoughTheOtherIsFarAway) {
    Dice dice{std::mt19937(36)};
    SolverRows rows;
    std::vector<double> near;
    std::vector<Below> truth;
    for (int i = 0; i < kRows; ++i) {
        const dvec4 b = spread(dice, 3, 0.25).moments();
        // Roots of q2 of README §1.
        const double slope = (b.z - b.x * b.y) / (b.y - b.x * b.x);
        const double root = std::sqrt(slope * slope / 4 - slope * b.x + b.y);
        rows.add(b, slope / 2 + (i % 2 ? root : -root));
        const ThreePoints points = threePoints(rows.moments(i), rows.t(i));
        near.push_back(std::abs(points.others.x) < std::abs(points.others.y) ? points.others.x
                                                                             : points.others.y);
        truth.push_back(points.below);
    }
    const Rows others = rows.evaluate("hamburger.glsl", "vec4(otherDepths(a, b.x), 0.0, 0.0)");
    const Rows blockers = rows.blockers("hamburger");
    double point = 0, share = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
        const double mine =
            std::abs(others[i].x) < std::abs(others[i].y) ? others[i].x : others[i].y;
        point = std::max(point, std::abs(mine - near[i]));
        share = std::max(share, std::abs(blockers[i].x - truth[i].share));
    }
    EXPECT_VALUE(point, LessOrEqual, kThreePoints.absolute, kThreePoints.cause);
    EXPECT_VALUE(share, LessOrEqual, kThreePoints.absolute, kThreePoints.cause);
}

// One or two depths and nothing else: what the bias is for. t lies where a receiver's does, on the
// farther depth or a bias before it, and anywhere.
TEST(Task3Hamburger, OneDepthOrTwoLoseOnlyTheBias) {
    Dice dice{std::mt19937(33)};
    SolverRows rows;
    std::vector<double> allowed;
    std::vector<Below> truth;
    for (int i = 0; i < kRows; ++i) {
        const double alpha = 1e-3 * (i % 2 ? 1 : 10);
        const Distribution d = spread(dice, 1 + i / 2 % 2, 0.1);
        const double places[] = {0, 0.005, dice(-0.05, 1)};
        const double t = std::max(d.depths.back() - places[i % 3], -1.0);
        rows.add(biased(d.moments(), alpha), t);
        truth.push_back(threePoints(rows.moments(i), rows.t(i)).below);
        allowed.push_back(shareRounding(alpha));
    }
    const Rows blockers = rows.blockers("hamburger");
    EXPECT_VALUE(worstShare(blockers, truth, allowed), LessOrEqual, 1, kShareCause);
    EXPECT_VALUE(worstDepth(blockers, truth, allowed), LessOrEqual, 1, kShareCause);
}

// Six depths have many distributions with the same moments. The bound is the least of them all.
TEST(Task3Hamburger, NeverMoreThanTheTrueShareAndNoLessThanTheBound) {
    Dice dice{std::mt19937(34)};
    SolverRows rows;
    std::vector<double> allowed;
    std::vector<Below> truth, bound;
    for (int i = 0; i < kRows; ++i) {
        const double alpha = std::pow(10, -2 - i % 3 * 0.75);
        const Distribution d = biased(randomDistribution(dice), alpha);
        rows.add(d.moments(), i % 5 == 0 ? d.depths[0] : dice(-1, 1));
        truth.push_back(d.below(rows.t(i)));
        bound.push_back(threePoints(rows.moments(i), rows.t(i)).below);
        allowed.push_back(shareRounding(alpha));
    }
    const Rows blockers = rows.blockers("hamburger");
    EXPECT_VALUE(mostOver(blockers, truth, allowed), LessOrEqual, 1,
                 "false shadow: more than can be nearer. " + kShareCause);
    EXPECT_VALUE(worstShare(blockers, bound, allowed), LessOrEqual, 1,
                 "light leaks: less than must be nearer. " + kShareCause);
}

TEST(Task3Hamburger, FiniteAndAShareForAnyMoments) {
    expectShares(anyMoments(35).blockers("hamburger"), anyMoments(35));
    const Rows others =
        anyMoments(35).evaluate("hamburger.glsl", "vec4(otherDepths(a, b.x), 0.0, 0.0)");
    double wrong = 0;
    for (const vec4& row : others) wrong = std::max(wrong, double(row.x - row.y));
    EXPECT_VALUE(wrong, LessOrEqual, 0,
                 "the smaller first; the runner has made sure that all are finite");
}

}  // namespace
}  // namespace penumbra
