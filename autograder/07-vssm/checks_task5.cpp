// Blockers from a mean: by similar triangles, and by two depths.
#include "variance_checks.h"

namespace penumbra {
namespace {

TEST(Task5Blockers, PenumbraFollowsSimilarTriangles) {
    Dice dice{std::mt19937(51)};
    Rows scale, depths, truth;
    for (int i = 0; i < kRows; ++i) {
        // Distances along the light's axis, from which depths and widths are made.
        const double nearPlane = dice(0.5, 5), farPlane = nearPlane * dice(1.5, 6);
        const double tangents = dice(0.5, 3), width = dice(0.1, 3), aspect = dice(0.5, 2);
        const double receiver = nearPlane + dice(0.05, 1) * (farPlane - nearPlane);
        const double blocker = nearPlane + dice(0, 0.9) * (receiver - nearPlane);
        const auto depth = [&](double z) {
            return farPlane / (farPlane - nearPlane) * (1 - nearPlane / z);
        };
        const double s = width * (1 / nearPlane - 1 / farPlane) / tangents;
        const bool behind = i % 8 == 0;  // the blocker: no penumbra then
        const double uv =
            behind ? 0 : width * (receiver - blocker) / blocker / (receiver * tangents);
        scale.emplace_back(dvec4(s, aspect * s, 0, 0));
        depths.emplace_back(behind ? dvec4(depth(blocker), depth(receiver), 0, 0)
                                   : dvec4(depth(receiver), depth(blocker), 0, 0));
        truth.emplace_back(dvec4(uv, aspect * uv, 0, 0));
    }
    const Rows penumbraWidthUv =
        evaluate({.chunk = "penumbra.glsl",
                  .expression = "vec4(penumbraWidthUv(a.xy, b.x, b.y), 0.0, 0.0)",
                  .inputs = {{"a", scale}, {"b", depths}}});
    EXPECT_ROWS_NEAR(penumbraWidthUv, truth,
                     {.absolute = 2e-6,
                      .relative = 1e-5,
                      .components = 2,
                      .cause = "depths are rounded to 6e-8 and S is at most 10; else float32"});
}

Rows blockerDepths(const Rows& rows) {  // (receiver, mean, lit)
    return evaluate({.chunk = "penumbra.glsl",
                     .expression = "vec4(meanBlockerDepth(a.x, a.y, a.z))",
                     .inputs = {{"a", rows}}});
}

TEST(Task5Blockers, TheBlockersDepthIsWhatTheMeanLacks) {
    Dice dice{std::mt19937(52)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const double blocker = dice(0, 0.8), receiver = blocker + dice(0, 1 - blocker);
        const double lit = i % 8 == 0 ? 0 : dice(0, 0.95);
        rows.emplace_back(dvec4(receiver, (1 - lit) * blocker + lit * receiver, lit, 0));
        truth.emplace_back(blocker);
    }
    EXPECT_ROWS_NEAR(blockerDepths(rows), truth,
                     {.absolute = 4e-6,
                      .relative = 0,
                      .cause = "two depths; mean, share and depth are rounded to 6e-8, over 0.05"});
}

TEST(Task5Blockers, TheBlockersDepthLiesBetweenLightAndReceiver) {
    Dice dice{std::mt19937(53)};
    Rows rows, truth;
    const auto add = [&](double receiver, double mean, double lit, double depth) {
        rows.emplace_back(dvec4(receiver, mean, lit, 0));
        truth.emplace_back(depth);
    };
    for (int i = 0; i < kRows / 4; ++i) {
        const double receiver = dice(0.2, 0.9), lit = dice(0.1, 0.9);
        add(receiver, receiver + dice(0.01, 0.1), lit, receiver);  // the mean is farther
        add(receiver, lit * receiver * dice(0.3, 0.99), lit, 0);   // more light than can be
        add(receiver, receiver - dice(0, 0.1), 1, receiver);       // no blocker
        add(receiver, receiver - dice(0, 1e-3), 1 - 1e-5, receiver);
    }
    EXPECT_ROWS_NEAR(blockerDepths(rows), truth,
                     {.absolute = 2e-7,
                      .relative = 0,
                      .cause = "0 or the receiver's depth: README §5 says which"});
}

}  // namespace
}  // namespace penumbra
