// Planar shadows: what of a caster stands between receiver and light.
#include "planar_checks.h"

namespace penumbra {
namespace {

// --- Task 4 ---

double sign(double x) { return x < 0 ? -1 : 1; }

TEST(Task4Clip, SignsTellWhatStandsBetween) {
    const Casters in(42, Casters::pointsAndSuns);
    const Rows signsOfClipDistances =
        in.ask("clip_caster.glsl", "vec4(sign(clipDistances(a, b, c.xyz)), 0.0, 0.0)");
    Rows truth;
    for (std::size_t i = 0; i < in.planes.size(); ++i) {
        const dvec4 plane(in.planes[i]), light(in.lights[i]);
        const double height = glm::dot(plane, dvec4(in.casters[i]));
        truth.emplace_back(sign(height), sign(glm::dot(plane, light) - light.w * height), 0, 0);
    }
    EXPECT_ROWS_NEAR(signsOfClipDistances, truth,
                     {.absolute = 0,
                      .relative = 0,
                      .components = 2,
                      .cause = "casters at least 0.1 from either boundary: no rounding decides"});
}

TEST(Task4Clip, DistancesAreLinearInTheCaster) {
    // The quotient of two casters' distances is free of scale, and right for linear ones alone.
    const Casters in(43, Casters::points);
    const Rows quotients =
        in.ask("clip_caster.glsl",
               "vec4(clipDistances(a, b, d.xyz) / clipDistances(a, b, c.xyz), 0.0, 0.0)");
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const dvec4 plane(in.planes[i]);
        const double light = glm::dot(plane, dvec4(in.lights[i]));
        const double height = glm::dot(plane, dvec4(in.casters[i]));
        const double other = glm::dot(plane, dvec4(in.others[i]));
        truth.emplace_back(other / height, (light - other) / (light - height), 0, 0);
    }
    EXPECT_ROWS_NEAR(quotients, truth,
                     {.absolute = 1e-4,
                      .relative = 1e-4,
                      .components = 2,
                      .cause = "heights from 0.1 on of coordinates up to 8, rounded to 1e-6"});
}

TEST(Task4Clip, ACasterAboveTheLightHasNoAntishadow) {
    // Divided by w at the corners, its image is not hidden by the rasteriser's own clipping.
    Scene scene = stage({0.7f, 5.0f, -0.9f});
    scene.meshes.push_back(polygonMesh(kFloating));
    Mesh above = scene.meshes[1];
    for (vec3& p : above.positions) p.y += 6.0f;
    scene.meshes.push_back(above);
    expectLikeRays(posed(scene, 1), {"form=matrix", "divide=on"},
                   "one caster below the light and its copy above: one shadow");
}

TEST(Task4Clip, ACasterBehindThePlaneHasNoFalseShadow) {
    for (const bool directional : {false, true}) {
        Scene scene = stage({0.7f, 5.0f, -0.9f}, directional);
        scene.meshes.push_back(polygonMesh(kFloating));
        scene.meshes.push_back(box({-2.0f, -1.5f, -1.0f}, {-1.0f, -0.5f, 0.0f}, 0));
        expectLikeRays(posed(scene, 2), {"form=matrix"},
                       "one caster above the plane and one below: one shadow");
    }
}

TEST(Task4Clip, StraddlingTrianglesCastTheExactPolygon) {
    for (const std::vector<dvec3>& caster : {kThroughThePlane, kPastTheLight, kThroughBoth})
        expectExactPolygon(caster, false, 4, {"form=matrix"});
    expectExactPolygon(kThroughBoth, true, 4, {"form=matrix"});
}

}  // namespace
}  // namespace penumbra
