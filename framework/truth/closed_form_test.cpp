#include "truth/closed_form.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace penumbra {

namespace {
// Exact in the tests' small numbers but for float64 rounding over a dozen operations.
constexpr double kRounding = 1e-12;

const Light kDownLight{.center = {0, 8, 0}, .right = {1, 0, 0}, .up = {0, 0, -1}, .width = 2.0f};
}  // namespace

TEST(ClosedForm, HalfPlanePenumbraIsLinearAndAsWideAsSimilarTrianglesSay) {
    const double h = 2, H = 8, L = 1.5, width = L * h / (H - h);
    EXPECT_EQ(halfPlaneVisibility(0.0, h, H, L), 0.5);
    EXPECT_NEAR(halfPlaneVisibility(width / 2, h, H, L), 1.0, kRounding);
    EXPECT_NEAR(halfPlaneVisibility(-width / 4, h, H, L), 0.25, kRounding);
    EXPECT_EQ(halfPlaneVisibility(-width, h, H, L), 0.0);
}

TEST(ClosedForm, PolygonOfAWideHalfPlaneEqualsTheHalfPlane) {
    const std::array blocker{glm::dvec3(-90, 2, -90), glm::dvec3(0, 2, -90), glm::dvec3(0, 2, 90),
                             glm::dvec3(-90, 2, 90)};
    for (double x = -1; x <= 1; x += 0.01)
        EXPECT_NEAR(polygonVisibility({x, 0, 0.3}, blocker, kDownLight),
                    halfPlaneVisibility(x, 2, 8, 2), kRounding);
}

TEST(ClosedForm, PolygonKeepsItsAnswerWhenAllIsTurned) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -3));
    const auto turned = [&](glm::dvec3 v) {  // by 1 radian, Rodrigues
        return v * std::cos(1.0) + glm::cross(axis, v) * std::sin(1.0) +
               axis * glm::dot(axis, v) * (1 - std::cos(1.0));
    };
    Light light = kDownLight;
    light.center = turned(light.center);
    light.right = turned(light.right);
    light.up = turned(light.up);
    const std::array flat{glm::dvec3(-0.4, 3, 0.1), glm::dvec3(0.6, 4, -0.3),
                          glm::dvec3(0.2, 5, 0.9)};
    const std::array tilted{turned(flat[0]), turned(flat[1]), turned(flat[2])};
    for (double x = -2; x <= 2; x += 0.25) {
        const glm::dvec3 receiver(x, 0, 0.2);
        EXPECT_NEAR(polygonVisibility(turned(receiver), tilted, light),
                    polygonVisibility(receiver, flat, kDownLight),
                    1e-6);  // the light's pose is float32
    }
}

TEST(ClosedForm, OnlyThePartOfAPolygonBetweenReceiverAndLightBlocks) {
    const std::array above{glm::dvec3(-1, 9, -1), glm::dvec3(1, 9, -1), glm::dvec3(0, 9, 1)};
    const std::array below{glm::dvec3(-1, -1, -1), glm::dvec3(1, -1, -1), glm::dvec3(0, -1, 1)};
    EXPECT_EQ(polygonVisibility({0, 0, 0}, above, kDownLight), 1.0);
    EXPECT_EQ(polygonVisibility({0, 0, 0}, below, kDownLight), 1.0);
    // A vertical wall x = 0 seen edge-on from its plane, and one that reaches past both ends.
    const std::array wall{glm::dvec3(0.1, -5, -50), glm::dvec3(0.1, 50, -50),
                          glm::dvec3(0.1, 50, 50), glm::dvec3(0.1, -5, 50)};
    EXPECT_NEAR(polygonVisibility({0, 0, 0}, wall, kDownLight), (1.0 + 0.1) / 2, kRounding);
    EXPECT_EQ(polygonVisibility({0, 9, 0}, wall, kDownLight), 0.0);  // behind the light
}

TEST(ClosedForm, HorizonCutsTheSquareAlongTheFacetsPlane) {
    EXPECT_EQ(horizonVisibility({0, 0, 0}, {0, 1, 0}, kDownLight), 1.0);
    EXPECT_EQ(horizonVisibility({0, 0, 0}, {0, -1, 0}, kDownLight), 0.0);
    EXPECT_NEAR(horizonVisibility({0, 0, 0}, {1, 0, 0}, kDownLight), 0.5, kRounding);
    EXPECT_NEAR(horizonVisibility({0.5, 0, 0}, {1, 0, 0}, kDownLight), 0.25, kRounding);
    EXPECT_EQ(horizonVisibility({0, 8, 0}, {0, 1, 0}, kDownLight), 0.0);
}

TEST(ClosedForm, SegmentMeetsATriangleStrictlyBetweenItsEnds) {
    const std::array triangle{glm::dvec3(-1, 2, -1), glm::dvec3(2, 2, -1), glm::dvec3(-1, 2, 2)};
    double margin = 0;
    EXPECT_FALSE(segmentIsFree({0, 0, 0}, {0, 8, 0, 1}, triangle, &margin));
    EXPECT_NEAR(margin, std::sqrt(0.5), kRounding);  // to the hypotenuse x + z = 1
    EXPECT_TRUE(segmentIsFree({1, 0, 1}, {1, 8, 1, 1}, triangle, &margin));
    EXPECT_NEAR(margin, std::sqrt(0.5), kRounding);
    EXPECT_TRUE(segmentIsFree({0, 3, 0}, {0, 8, 0, 1}, triangle, &margin));
    EXPECT_NEAR(margin, 1.0, kRounding);                                     // past the start
    EXPECT_TRUE(segmentIsFree({0, 2, 0}, {0, 8, 0, 1}, triangle, &margin));  // its own facet
    EXPECT_EQ(margin, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(segmentIsFree({0, 0, 0}, {5, 0, 0, 1}, triangle));  // parallel
}

TEST(ClosedForm, ADirectionMeetsATriangleAnywhereAheadOfTheReceiver) {
    const std::array triangle{glm::dvec3(-1, 2, -1), glm::dvec3(2, 2, -1), glm::dvec3(-1, 2, 2)};
    double margin = 0;
    EXPECT_FALSE(segmentIsFree({0, 0, 0}, {0, 1, 0, 0}, triangle, &margin));
    EXPECT_NEAR(margin, std::sqrt(0.5), kRounding);
    EXPECT_FALSE(segmentIsFree({0, 1.75, 0}, {0, 1, 0, 0}, triangle, &margin));
    EXPECT_NEAR(margin, 0.25, kRounding);                                        // before the start
    EXPECT_TRUE(segmentIsFree({0, 0, 0}, {0.6, 0.8, 0, 0}, triangle, &margin));  // at (1.5, 2, 0)
    EXPECT_NEAR(margin, std::sqrt(0.125), kRounding);
    EXPECT_TRUE(segmentIsFree({0, 0, 0}, {0, -1, 0, 0}, triangle));  // behind
    EXPECT_TRUE(segmentIsFree({0, 0, 0}, {1, 0, 0, 0}, triangle));   // parallel
}

TEST(ClosedForm, NothingIsLitFromTheRangeOn) {
    Light light = kDownLight;
    light.range = 8.5f;
    const glm::dvec3 inside{2.8, 0, 0}, outside{2.9, 0, 0};  // √(8² + x²) is 8.48 and 8.51
    EXPECT_EQ(polygonVisibility(inside, {}, light), 1.0);
    EXPECT_EQ(polygonVisibility(outside, {}, light), 0.0);
    EXPECT_EQ(horizonVisibility(inside, {0, 1, 0}, light), 1.0);
    EXPECT_EQ(horizonVisibility(outside, {0, 1, 0}, light), 0.0);
}

TEST(ClosedForm, PlanarDepthBiasIsTheDepthStepOverTheFootprint) {
    EXPECT_NEAR(planarDepthBias(0.1, std::tan(1.0), 0.0), 0.05 * std::tan(1.0), kRounding);
    EXPECT_NEAR(planarDepthBias(0.1, 1.0, 2.0), 0.25, kRounding);
}

}  // namespace penumbra
