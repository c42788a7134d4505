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
// sin(angle) = n · d, and there the distance rises along n. So the plane is n / cos(angle).
TEST(Task6Edge, ReceiverAndEdgeSpanAPlane) {
    Dice dice(62);
    Rows directions, gradients, truth;
    while (int(truth.size()) < kRows) {
        const dvec3 n = dice.direction(), d = dice.direction();
        const double sine = glm::dot(n, d);
        if (std::abs(sine) > 0.9) continue;
        const bool alongTheRay = truth.size() % 8 == 0;
        directions.emplace_back(dvec4(d, std::tan(std::asin(sine))));
        // Between voxels a gradient is not of unit length.
        gradients.emplace_back(dvec4(alongTheRay ? sine * d : dice(0.7, 1.2) * n, 0));
        truth.emplace_back(dvec4(alongTheRay ? dvec3(0) : n / std::sqrt(1 - sine * sine), 0));
    }
    const Rows edgePlane = evaluate({.chunk = "analytic_gradient.glsl",
                                     .expression = "vec4(edgePlane(a.w, a.xyz, b.xyz), 0.0)",
                                     .inputs = {{"a", directions}, {"b", gradients}}});
    EXPECT_ROWS_NEAR(
        edgePlane, truth,
        {.absolute = 1e-5,
         .components = 3,
         .cause = "float32; sines up to 0.9, so lengths up to 2.3. A gradient along the "
                  "ray has no part across it: 0"});
}

TEST(Task6Edge, ATurnedSlabHidesAnExactShare) {
    EXPECT_VALUE(errorUnderSlab({.thickness = 1, .turnRadians = 0.5}, {"method=edge", "grid=64"}),
                 LessOrEqual, 0.025,
                 "voxels of 0.15: the edge is off by up to half of one, 0.07 / 3.8 of the light's "
                 "0.19: a tenth at worst, a quarter of that in the mean square");
}

}  // namespace
}  // namespace penumbra
