// Between two look-ups: where the ray came nearest, if it did, and how near.
#include <algorithm>
#include <cmath>

#include "field_checks.h"

namespace penumbra {
namespace {

// Rows of (before, here, stepTaken) and what is known of them.
struct Looks {
    Rows rows, truth;
    void add(double before, double here, double step, double back, double distance) {
        rows.emplace_back(dvec4(before, here, step, 0));
        truth.emplace_back(dvec4(back, distance, 0, 0));
    }
};

Rows closestApproach(const Rows& rows) {
    return evaluate({.chunk = "closest_approach.glsl",
                     .expression = "vec4(closestApproach(a.x, a.y, a.z), 0.0, 0.0)",
                     .inputs = {{"a", rows}}});
}

// A post, `aside` of the ray, passed `back` ago: its distance at both look-ups is a root.
TEST(Task4ClosestApproach, APostBetweenTwoLookUpsIsMetExactly) {
    Dice dice(41);
    Looks looks;
    for (int i = 0; i < kRows; ++i) {
        const double step = dice(0.1, 2), back = dice(0.02, 0.98) * step, aside = dice(0.05, 1);
        looks.add(std::hypot(aside, step - back), std::hypot(aside, back), step, back, aside);
    }
    EXPECT_ROWS_NEAR(
        closestApproach(looks.rows), looks.truth,
        {.absolute = 2e-5,
         .relative = 1e-4,
         .components = 2,
         .cause = "differences of squares up to 5, rounded to 5e-7, over 0.1 and more"});
}

TEST(Task4ClosestApproach, WhereTheCirclesDoNotMeetBetweenOnlyTheLookUpCounts) {
    Dice dice(42);
    Looks looks;
    for (int i = 0; i < kRows; ++i) {
        const double step = dice(0.1, 2), aside = dice(0.05, 1), here = dice(0.05, 1);
        switch (i % 6) {
            case 0:  // no look-up before this one
                looks.add(0, here, 0, 0, here);
                break;
            case 1:  // still approaching: the post lies ahead
            {
                const double ahead = dice(0.05, 2);
                looks.add(std::hypot(aside, step + ahead), std::hypot(aside, ahead), step, 0,
                          std::hypot(aside, ahead));
                break;
            }
            case 2:  // passed before the look-up before
            {
                const double passed = dice(0.05, 2);
                looks.add(std::hypot(aside, passed), std::hypot(aside, step + passed), step, 0,
                          std::hypot(aside, step + passed));
                break;
            }
            case 3:  // inside now
                looks.add(here, -dice(0.01, 0.3), step, 0, 0);
                looks.truth.back().y = looks.rows.back().y;
                break;
            case 4:  // inside before
                looks.add(-dice(0.01, 0.3), here, step, 0, here);
                break;
            default:  // at the surface
                looks.add(here, 0, step, 0, 0);
        }
    }
    EXPECT_ROWS_NEAR(closestApproach(looks.rows), looks.truth,
                     {.components = 2, .cause = "the look-up is given back as it came"});
}

// A post that is a point in the ray's plane: whatever the steps, the march has its exact place.
// What a later look-up may find instead is the sine of the same angle, not the tangent.
TEST(Task4ClosestApproach, TheMarchCountsWhatLiesBetweenItsLookUps) {
    Dice dice(43);
    Rows centers, marches, truth;
    for (int i = 0; i < kRows; ++i) {
        const double along = dice(1, 3), tangent = dice(0.05, 0.1);
        centers.emplace_back(dvec4(1 + tangent * along, -2, 3 + along, 0));
        marches.emplace_back(dvec4(dice(0.05, 0.2), 2 * along, 0, 0));
        truth.emplace_back(tangent);
    }
    const Rows marched = evaluate(
        {.chunk = "analytic_approach.glsl",
         .expression = "vec4(marchRoundedBox(a.xyz, vec3(0.0), 0.0, vec3(1.0, -2.0, 3.0), "
                       "vec3(0.0, 0.0, 1.0), b.x, b.y, Limits(0.15, 0.0, 0.7, 0.001, 100)).ratio)",
         .inputs = {{"a", centers}, {"b", marches}}});
    EXPECT_ROWS_NEAR(marched, truth,
                     {.absolute = 6e-4,
                      .relative = 0,
                      .cause = "between sine and tangent of an angle of at most 0.1: its cube's "
                               "half, 5e-4, and float32"});
}

}  // namespace
}  // namespace penumbra
