// The march: no step that could pass a nearer place, none shorter than it must be, an end where it
// should end. Truths: planes and spheres, whose least distance / t is a formula.
#include <algorithm>
#include <cmath>

#include "marches.h"

namespace penumbra {
namespace {

TEST(Task2March, RaysStartOverTheSurface) {
    Dice dice(21);
    Rows positions, normals, truth;
    for (int i = 0; i < kRows; ++i) {
        const dvec3 position = dice.point(-5, 5), normal = dice.direction();
        const double offset = i % 8 == 0 ? 0 : dice(0, 0.3);
        positions.emplace_back(dvec4(position, 0));
        normals.emplace_back(dvec4(normal, offset));
        truth.emplace_back(dvec4(position + offset * normal, 0));
    }
    const Rows rayStart = evaluate({.chunk = "analytic_march.glsl",
                                    .expression = "vec4(rayStart(a.xyz, b.xyz, b.w), 0.0)",
                                    .inputs = {{"a", positions}, {"b", normals}}});
    EXPECT_ROWS_NEAR(
        rayStart, truth,
        {.absolute = 2e-6, .components = 3, .cause = "coordinates up to 5 in float32"});
}

// A distance of d at t leaves no place nearer than d - s after a step s: so the longest step that
// cannot pass one below the ratio found so far, (d - s) / (t + s) = ratio.
TEST(Task2March, StepsAreSoundAndAsLongAsAllowed) {
    Dice dice(22);
    Rows places, limits, truth;
    for (int i = 0; i < kRows; ++i) {
        const double t = dice(0.01, 8), distance = dice(-0.5, 3);
        // What was found so far is at most what is here.
        const double ratio = std::min(distance / t, i % 2 ? dice(-0.2, 0.2) : dice(0, 0.05));
        const double cap = i % 4 == 0 ? 1 : dice(0.02, 1), smallest = dice(0.001, 0.1);
        const double sound = (distance - ratio * t) / (1 + ratio);
        if (1 + ratio < 0.1) {
            --i;
            continue;
        }
        places.emplace_back(dvec4(distance, t, ratio, 0));
        limits.emplace_back(dvec4(cap, smallest, 0, 0));
        truth.emplace_back(std::max({sound, cap * std::abs(distance), smallest}));
    }
    const Rows stepLength = evaluate({.chunk = "analytic_march.glsl",
                                      .expression = "vec4(stepLength(a.x, a.y, a.z, b.x, b.y))",
                                      .inputs = {{"a", places}, {"b", limits}}});
    EXPECT_ROWS_NEAR(
        stepLength, truth,
        {.absolute = 2e-5, .cause = "a difference of two terms up to 3, over 0.1 and more"});
}

TEST(Task2March, ASphereIsMetAtItsClosedForm) {
    const SphereMarches spheres(23, {0.05});
    EXPECT_ROWS_NEAR(marched(spheres.marches), spheres.truth,
                     {.absolute = 1e-3, .relative = 0, .cause = "T7 at step cap 0.05"});
}

// Around its least value, distance / t curves like 1 / (distance + radius) / t; a look-up is at
// most half a step, cap · distance / 2, beside it: cap² / 8 of the ratio too much, at most.
TEST(Task2March, TheErrorFallsWithTheSquareOfTheStepCap) {
    const SphereMarches spheres(24, {0.5, 0.2, 0.05, 0.02});
    const Rows found = marched(spheres.marches);
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const double cap = spheres.marches[kind].stepCap;
        double low = INFINITY, high = 0;
        for (std::size_t i = kind; i < found.size(); i += 4) {
            const double error = double(found[i].x) / double(spheres.truth[i].x) - 1;
            low = std::min(low, error), high = std::max(high, error);
        }
        EXPECT_VALUE(low, GreaterOrEqual, -1e-4, "no look-up finds less than there is; float32");
        EXPECT_VALUE(high, LessOrEqual, 1.2 * cap * cap / 8 + 1e-4,
                     "cap² / 8, a fifth more for the third power; float32");
    }
}

// A ray along x over, or into, a box so wide that only one face counts: a plane.
March overPlane(double height) {
    March march;
    march.shape = {kOrigin - dvec3(0, height + 4, 0), dvec3(20, 4, 20)};
    march.direction = {1, 0, 0};
    return march;
}
March intoPlane(double ahead) {
    March march;
    march.shape = {kOrigin + dvec3(ahead + 8, 0, 0), dvec3(8, 20, 20)};
    march.direction = {1, 0, 0};
    return march;
}

// Along a plane the ratio falls to the ray's end, and every look-up is the least so far: steps are
// as short as they may be, cap · height or the smallest one. So all of the march is a formula.
TEST(Task2March, AlongAPlaneItLooksUpToTheEnd) {
    Dice dice(25);
    std::vector<March> marches;
    Rows truth;
    while (int(truth.size()) < kRows) {
        const double height = dice(0.05, 0.5);
        March march = overPlane(height);
        march.first = dice(0.1, 0.5), march.reach = dice(1, 6);
        march.highest = 100, march.lowest = -1;
        march.stepCap = dice(0.1, 1), march.smallest = dice(0.01, 0.2);
        march.maxSteps = int(dice(1, 60));
        const double step = std::max(march.stepCap * height, march.smallest);
        const double steps = (march.reach - march.first) / step;
        if (std::abs(steps - std::round(steps)) < 0.02) continue;  // a look-up at the end itself
        const int lookUps = std::min(march.maxSteps, int(std::ceil(steps)));
        const double last = march.first + (lookUps - 1) * step;
        marches.push_back(march);
        truth.emplace_back(dvec4(height / last, last, lookUps, 0));
    }
    EXPECT_ROWS_NEAR(
        marched(marches), truth,
        {.absolute = 1e-5,
         .relative = 2e-4,
         .components = 3,
         .cause = "heights of 0.05 and more are differences of coordinates up to 9, "
                  "rounded to 1e-6; no row's last step ends within 0.02 of the light"});
}

TEST(Task2March, ItEndsWhereNothingDarkerCanCome) {
    Dice dice(26);
    std::vector<March> marches;
    Rows truth;
    while (int(truth.size()) < kRows) {
        March march;
        const double first = dice(0.02, 0.2);
        dvec4 end;
        if (truth.size() % 2 == 0) {  // from the inside: one look-up says it all
            const double depth = dice(0.05, 0.5);
            march = overPlane(-depth);
            march.lowest = -dice(0, 1) * depth / first;
            end = {-depth / first, first, 1, 0};
        } else {
            const double ahead = dice(1, 3);
            march = intoPlane(ahead);
            march.lowest = truth.size() % 4 == 1 ? 0 : -dice(0.01, 0.2);
        }
        march.first = first, march.reach = 12, march.highest = 0.4;
        march.stepCap = dice(0.1, 0.9), march.smallest = dice(0.01, 0.05), march.maxSteps = 500;
        bool close = false;  // to another number of look-ups
        if (truth.size() % 2 == 1) {
            const double ahead = march.shape.center.x - 8 - kOrigin.x;
            double t = first, lowest = march.highest;
            for (int lookUps = 1;; ++lookUps) {
                const double distance = ahead - t, ratio = distance / t;
                close = close || std::abs(ratio - march.lowest) < 1e-3;
                lowest = std::min(lowest, ratio);
                end = {lowest, t, lookUps, 0};
                if (lowest <= march.lowest) break;
                t += std::max({(distance - lowest * t) / (1 + lowest),
                               march.stepCap * std::abs(distance), march.smallest});
            }
        }
        if (close) continue;
        marches.push_back(march);
        truth.emplace_back(end);
    }
    EXPECT_ROWS_NEAR(marched(marches), truth,
                     {.absolute = 1e-5,
                      .relative = 2e-4,
                      .components = 3,
                      .cause = "depths of 0.05 and more are differences of coordinates up to 20, "
                               "rounded to 2e-6, over t of 0.02 and more"});
}

TEST(Task2March, WhatLiesBehindTheLightBlocksNothing) {
    Dice dice(27);
    std::vector<March> marches;
    Rows truth;
    for (int i = 0; i < kRows; ++i) {
        const double reach = dice(2, 8), highest = dice(0.02, 0.2);
        // Touches the ray just behind the light, or is nowhere near.
        const double behind = i % 2 ? 1.05 : dice(2, 3);
        const double radius = dice(0.2, 1);
        marches.push_back(
            {.shape = {kOrigin + (reach * (1 + 2 * highest) * behind + radius) * kOblique, dvec3(0),
                       radius},
             .first = 0.05,
             .reach = reach,
             .highest = highest,
             .lowest = 0,
             .stepCap = 0.5,
             .smallest = 0.05,
             .maxSteps = 1000});
        truth.emplace_back(dvec4(highest, reach, 0, 0));
    }
    EXPECT_ROWS_NEAR(
        marched(marches), truth,
        {.components = 2, .cause = "nothing is found: both are given back as they came"});
}

}  // namespace
}  // namespace penumbra
