// The blocker's edge as a line across the light.
#include <algorithm>
#include <cmath>

#include "field_checks.h"

namespace penumbra {
namespace {

// Away from corners and kinks: a rounded box seen from its corners' eighths is a sphere's distance.
TEST(Task6Edge, TheGradientPointsAwayFromTheNearestPoint) {
    Dice dice(61);
    Rows points, centers, sizes, truth;
    for (int i = 0; i < kRows; ++i) {
        const dvec3 center = dice.point(-2, 2), half = dice.point(0.2, 1);
        const dvec3 sign = glm::sign(dice.point(-1, 1));
        const dvec3 away = sign * dice.point(0.1, 1);
        points.emplace_back(dvec4(center + sign * half + away, 0.02));
        centers.emplace_back(dvec4(center, 0.1));
        sizes.emplace_back(dvec4(half, 0));
        truth.emplace_back(dvec4(glm::normalize(away), 0));
    }
    const Rows gradient =
        evaluate({.chunk = "analytic_gradient.glsl",
                  .expression = "vec4(gradientRoundedBox(b.xyz, c.xyz, b.w, a.xyz, a.w), 0.0)",
                  .inputs = {{"a", points}, {"b", centers}, {"c", sizes}}});
    EXPECT_ROWS_NEAR(gradient, truth,
                     {.absolute = 4e-3,
                      .components = 3,
                      .cause = "central differences over 0.02 of a distance that curves over 0.17 "
                               "and more: (0.02 / 0.17)² / 6; rounding adds 1e-6 / 0.04"});
}

// A straight edge and the receiver span a plane with normal n; a ray along d passes the edge at
// sin(angle) = n · d, and there the distance rises along n. Light points are hidden below the
// plane.
TEST(Task6Edge, ALightPointIsHiddenBelowThePlaneOfReceiverAndEdge) {
    Dice dice(62);
    Rows directions, gradients, points, truth;
    while (int(truth.size()) < kRows) {
        const dvec3 n = dice.direction(), d = dice.direction();
        const double sine = glm::dot(n, d);
        if (std::abs(sine) > 0.8) continue;
        const dvec3 l = 8.0 * (d + 0.5 * dice.direction());
        const double over = glm::dot(n, l);
        if (std::abs(over) < 1e-2) continue;
        directions.emplace_back(dvec4(d, std::tan(std::asin(sine))));
        gradients.emplace_back(
            dvec4(dice(0.7, 1.2) * n, 0));  // between voxels it is not of unit length
        points.emplace_back(dvec4(l, 0));
        truth.emplace_back(over > 0 ? 1 : 0);
    }
    const Rows visible =
        evaluate({.chunk = "analytic_gradient.glsl",
                  .expression = "vec4(dot(edgePlane(a.w, a.xyz, b.xyz), c.xyz) > 0.0 ? 1.0 : 0.0)",
                  .inputs = {{"a", directions}, {"b", gradients}, {"c", points}}});
    EXPECT_ROWS_NEAR(visible, truth, {.cause = "no light point is nearer to the plane than 0.01"});
}

TEST(Task6Edge, WhereTheGradientIsAlongTheRayThereIsNoEdge) {
    Dice dice(63);
    Rows directions, gradients;
    for (int i = 0; i < kRows; ++i) {
        const dvec3 d = dice.direction();
        directions.emplace_back(dvec4(d, dice(-1, 1)));
        gradients.emplace_back(dvec4(i % 4 == 0 ? dvec3(0) : dice(-1, 1) * d, 0));
    }
    const Rows edgePlane = evaluate({.chunk = "analytic_gradient.glsl",
                                     .expression = "vec4(edgePlane(a.w, a.xyz, b.xyz), 0.0)",
                                     .inputs = {{"a", directions}, {"b", gradients}}});
    EXPECT_ROWS_NEAR(edgePlane, Rows(kRows, vec4(0)),
                     {.absolute = 0, .components = 3, .cause = "no direction across the ray"});
}

TEST(Task6Edge, ATurnedSlabHidesAnExactShare) {
    EXPECT_VALUE(errorUnderSlab({.thickness = 1, .turnRadians = 0.5}, {"method=edge", "grid=64"}),
                 LessOrEqual, 0.02, "TBD");
}

}  // namespace
}  // namespace penumbra
