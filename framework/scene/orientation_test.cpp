#include "scene/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/random.h"

namespace penumbra {
namespace {

struct Case {
    glm::vec3 a, b, c;
    glm::vec4 light;
};

int signOf(const Case& k) { return orientation(k.a, k.b, k.c, k.light); }

Case scaled(Case k, float factor) {
    // The light's point, not its homogeneous form: w stays.
    return {factor * k.a, factor * k.b, factor * k.c,
            glm::vec4(factor * glm::vec3(k.light), k.light.w)};
}

// For integer coordinates below 2^24. Whole numbers modulo 2^64 add and multiply exactly; where the
// float64 determinant is below 2^62, the true one, at most 2^40 away from it, is the one number of
// its class below 2^63 (coordinates of 2^24 make terms of at most 2^77: 2^-53 of 24 of these).
int integerSign(const Case& k) {
    const auto whole = [](float x) { return std::uint64_t(std::int64_t(x)); };
    std::uint64_t u[3], v[3], t[3];
    for (int i = 0; i < 3; ++i) {
        u[i] = whole(k.b[i]) - whole(k.a[i]);
        v[i] = whole(k.c[i]) - whole(k.a[i]);
        t[i] = whole(k.light[i]) - whole(k.light.w) * whole(k.a[i]);
    }
    std::uint64_t determinant = 0;
    double estimate = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, n = (i + 2) % 3;
        determinant += t[i] * (u[j] * v[n] - u[n] * v[j]);
        const auto real = [](std::uint64_t x) { return double(std::int64_t(x)); };
        estimate += real(t[i]) * (real(u[j]) * real(v[n]) - real(u[n]) * real(v[j]));
    }
    if (std::abs(estimate) > 0x1p62) return estimate > 0.0 ? 1 : -1;
    const auto exact = std::int64_t(determinant);
    return (exact > 0) - (exact < 0);
}

glm::vec3 integers(Random& random, float reach) {
    const auto one = [&] { return std::round(random.between(-reach, reach)); };
    const float x = one(), y = one(), z = one();
    return {x, y, z};
}

TEST(Orientation, LightThatSeesTheTriangleCounterClockwiseIsOnThePlusSide) {
    const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_EQ(orientation(a, b, c, {5, 5, 2, 1}), 1);
    EXPECT_EQ(orientation(a, b, c, {5, 5, -2, 1}), -1);
    EXPECT_EQ(orientation(a, b, c, {5, 5, 0, 1}), 0);
    EXPECT_EQ(orientation(a, b, c, {0, 0, 1, 0}), 1) << "directional, from +z";
    EXPECT_EQ(orientation(a, b, c, {0, 0, -1, 0}), -1);
    EXPECT_EQ(orientation(a, b, c, {3, 1, 0, 0}), 0) << "directional, along the plane";
}

TEST(Orientation, EqualsIntegerArithmetic) {
    Random random(1);
    for (const float reach : {2.0f, 40.0f, 0x1p12f, 0x1.fffffep23f})
        for (int i = 0; i < 20000; ++i) {
            const float w = float(random.bits() % 2);
            const Case k{integers(random, reach), integers(random, reach), integers(random, reach),
                         glm::vec4(integers(random, reach), w)};
            ASSERT_EQ(signOf(k), integerSign(k)) << reach << " case " << i;
        }
}

// Light = a + i (b - a) + j (c - a) on integers: coplanar, and one unit in the last place of one
// coordinate off the plane. Float64 alone is wrong about many of these.
TEST(Orientation, TellsCoplanarFromOneUlpOff) {
    Random random(2);
    int nudged = 0;
    for (int n = 0; n < 20000; ++n) {
        const glm::vec3 a = integers(random, 0x1p21f), u = integers(random, 0x1p18f),
                        v = integers(random, 0x1p18f);
        const glm::vec3 step = integers(random, 2.0f);
        Case k{a, a + u, a + v, glm::vec4(a + step.x * u + step.y * v, 1.0f)};
        ASSERT_EQ(signOf(k), 0) << n;
        const int axis = n % 3;
        const float toward = n % 2 ? 1e30f : -1e30f;
        k.light[axis] = std::nextafter(k.light[axis], toward);
        const glm::dvec3 normal = glm::cross(glm::dvec3(u), glm::dvec3(v));  // exact: 38 bits
        const int expected = ((normal[axis] > 0.0) - (normal[axis] < 0.0)) * (n % 2 ? 1 : -1);
        ASSERT_EQ(signOf(k), expected) << n;
        nudged += expected != 0;
    }
    EXPECT_GT(nudged, 19000);
}

TEST(Orientation, PowersOfTwoChangeNothing) {
    Random random(3);
    for (int n = 0; n < 5000; ++n) {
        const glm::vec3 a = integers(random, 9.0f), u = integers(random, 9.0f),
                        v = integers(random, 9.0f);
        const bool flat = n % 2;
        const Case k{a, a + u, a + v,
                     glm::vec4(flat ? a + 2.0f * u - v : integers(random, 20.0f), 1.0f)};
        const int expected = integerSign(k);
        // 2^-149 makes every coordinate denormal; 2^122 puts them just below the largest float.
        for (const int exponent : {-149, -126, -100, -40, -1, 1, 24, 60, 122})
            ASSERT_EQ(signOf(scaled(k, std::ldexp(1.0f, exponent))), expected)
                << n << " times 2^" << exponent;
    }
}

// Magnitudes from the smallest to the largest float in one determinant.
TEST(Orientation, HoldsOverTheWholeRangeOfFloat) {
    constexpr float tiny = std::numeric_limits<float>::denorm_min();
    constexpr float huge = std::numeric_limits<float>::max();
    const glm::vec3 a(0, 0, 0), b(huge, 0, 0), c(0, huge, 0);
    EXPECT_EQ(orientation(a, b, c, {huge, -huge, tiny, 1}), 1);
    EXPECT_EQ(orientation(a, b, c, {huge, -huge, -tiny, 1}), -1);
    EXPECT_EQ(orientation(a, b, c, {huge, -huge, 0, 1}), 0);
    // With 0 for the denormal, light = b + c - a lies in the plane; in float64 1 - denormal is 1.
    EXPECT_EQ(orientation({0, 0, tiny}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2, 1}), 1);
    EXPECT_EQ(orientation({0, 0, -tiny}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2, 1}), -1);
    constexpr float far = 0x1p100f, near = 0x1p-100f;
    EXPECT_EQ(orientation({0, 0, far}, {1, 0, far}, {0, 1, far}, {0, 0, near, 0}), 1);
}

TEST(Orientation, SwappingCornersTurnsTheSign) {
    Random random(4);
    for (int n = 0; n < 5000; ++n) {
        const auto point = [&] {
            return glm::vec3(random.between(-3, 3), random.between(-3, 3), random.between(-3, 3));
        };
        const glm::vec3 a = point(), b = point(), c = point();
        // Every other light lies within rounding of the plane, where only exactness is consistent.
        const glm::vec3 l = n % 2 ? 0.3f * a + 0.6f * b + 0.1f * c : point();
        const glm::vec4 light(l, 1.0f);
        const int sign = orientation(a, b, c, light);
        EXPECT_EQ(orientation(b, c, a, light), sign);
        EXPECT_EQ(orientation(c, a, b, light), sign);
        EXPECT_EQ(orientation(b, a, c, light), -sign);
        EXPECT_EQ(orientation(a, c, b, light), -sign);
        EXPECT_EQ(orientation(a, b, l, glm::vec4(c, 1.0f)), -sign) << "apex and corner";
    }
}

TEST(Orientation, TriangleWithoutAreaHasNoSides) {
    const glm::vec3 a(0.1f, 0.2f, 0.3f), b(0.7f, -0.4f, 1.1f);
    for (const glm::vec4 light : {glm::vec4(3, 8, 2, 1), glm::vec4(0.3f, 0.9f, 0.1f, 0)}) {
        EXPECT_EQ(orientation(a, a, b, light), 0);
        EXPECT_EQ(orientation(a, b, b, light), 0);
        EXPECT_EQ(orientation(a, a, a, light), 0);
        EXPECT_EQ(orientation({1, 1, 1}, {2, 2, 2}, {5, 5, 5}, light), 0);
    }
}

}  // namespace
}  // namespace penumbra
