// The bound: two depths, three, one; and the normal distribution's tail.
#include "variance_checks.h"

namespace penumbra {
namespace {

// A share `lit` of a box at the depth `far`, the rest at `near`.
struct TwoDepths {
    double near, far, lit;

    explicit TwoDepths(Dice& dice)
        : near(dice(0, 0.8)), far(near + dice(0.05, 0.9 - near)), lit(dice(0.02, 0.98)) {}
    double mean() const { return (1 - lit) * near + lit * far; }
    double variance() const { return lit * (1 - lit) * (far - near) * (far - near); }
};

Rows boundOf(const Rows& rows) {  // (depth, mean, variance)
    return evaluate({.chunk = "chebyshev.glsl",
                     .expression = "vec4(chebyshev(a.x, a.yz))",
                     .inputs = {{"a", rows}}});
}

const RowTolerance kBound{.absolute = 1e-4,
                          .relative = 0,
                          .cause =
                              "exact; mean and depth are rounded to 3e-8 each, and are at "
                              "least 1e-3 apart"};

TEST(Task4Bound, TheFartherOfTwoDepthsIsExact) {
    Dice dice{std::mt19937(41)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const TwoDepths box(dice);
        rows.emplace_back(dvec4(box.far, box.mean(), box.variance(), 0));
        truth.emplace_back(box.lit);
    }
    EXPECT_ROWS_NEAR(boundOf(rows), truth, kBound);
}

TEST(Task4Bound, AThirdDepthGetsLightAsTheBoundSays) {
    Dice dice{std::mt19937(42)};
    Rows rows{{0.8f, 0.5f, 0.04f, 0}, {0.9f, 0.5f, 0.04f, 0}}, truth{vec4(0.30769f), vec4(0.2f)};
    for (int i = 0; i < kRows; ++i) {
        const TwoDepths box(dice);
        const double depth = box.far + dice(0.01, 1 - box.far);
        rows.emplace_back(dvec4(depth, box.mean(), box.variance(), 0));
        truth.emplace_back(upperBound(depth, {box.mean(), box.variance()}));
    }
    EXPECT_ROWS_NEAR(boundOf(rows), truth, kBound);
}

TEST(Task4Bound, WhatIsNotFartherThanTheMeanIsLit) {
    Dice dice{std::mt19937(43)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const float mean = float(dice(0.1, 1)), variance = i % 2 == 0 ? 0.0f : float(dice(0, 0.2));
        const float depth = i % 4 < 2 ? mean : mean - float(dice(0.001, 0.1));
        rows.emplace_back(depth, mean, variance, 0);
        truth.emplace_back(1.0f);
    }
    for (int i = 0; i < 8; ++i) {
        rows.emplace_back(0.5f + std::exp2(-float(2 * i + 1)), 0.5f, 0, 0);
        truth.emplace_back(0.0f);
    }
    EXPECT_ROWS_NEAR(boundOf(rows), truth,
                     {.absolute = 0,
                      .relative = 0,
                      .cause = "exactly 1; without variance exactly 0 where it is farther"});
}

TEST(Task4Bound, LessBleedingKeepsZeroAndOne) {
    Dice dice{std::mt19937(44)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const double amount = i % 8 == 0 ? 0 : dice(0, 0.9);
        const double bound = i % 8 == 1 ? 1 : i % 8 == 2 ? 0 : dice(0, 1);
        rows.emplace_back(dvec4(bound, amount, 0, 0));
        truth.emplace_back(std::max((bound - amount) / (1 - amount), 0.0));
    }
    const Rows lessBleeding = evaluate({.chunk = "chebyshev.glsl",
                                        .expression = "vec4(lessBleeding(a.x, a.y))",
                                        .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(lessBleeding, truth,
                     {.absolute = 2e-6, .cause = "a difference of shares, over 0.1 at least"});
}

TEST(Task4Bound, TheNormalTailIsWhatLiesBeyond) {
    Dice dice{std::mt19937(45)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const float mean = float(dice(0.2, 0.8)), variance = float(std::pow(10, dice(-8, -1.4)));
        const float depth = i % 8 == 0 ? mean : mean + float(dice(-4, 4) * std::sqrt(variance));
        rows.emplace_back(depth, mean, variance, 0);
        truth.emplace_back(
            0.5 * std::erfc((double(depth) - double(mean)) / std::sqrt(2 * double(variance))));
    }
    const Rows normalTail = evaluate({.chunk = "chebyshev.glsl",
                                      .expression = "vec4(normalTail(a.x, a.yz))",
                                      .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(normalTail, truth,
                     {.absolute = 5e-6,
                      .cause = "the given error function is good to 2e-6, its argument to 1e-6"});
    // No variance at all: a step, and finite.
    const Rows flat{{0.3f, 0.5f, 0, 0}, {0.7f, 0.5f, 0, 0}, {0.5f, 0.5f, 0, 0}};
    const Rows withoutVariance = evaluate({.chunk = "chebyshev.glsl",
                                           .expression = "vec4(normalTail(a.x, a.yz))",
                                           .inputs = {{"a", flat}}});
    EXPECT_ROWS_NEAR(withoutVariance, (Rows{vec4(1.0f), vec4(0.0f), vec4(0.5f)}),
                     {.absolute = 5e-6, .cause = "a step from 1 to 0, 1/2 on the depth itself"});
}

}  // namespace
}  // namespace penumbra
