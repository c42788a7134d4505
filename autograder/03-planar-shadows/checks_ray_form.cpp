// Planar shadows: the matrix's product taken apart, so that it does not cancel.
#include <fmt/format.h>

#include "near_the_light.h"

namespace penumbra {
namespace {

// --- Task 5 ---

Rows askRay(const Casters& in, const char* expression) {
    return in.ask("ray_form.glsl", expression);
}

TEST(Task5RayForm, PointsLieOnTheirRays) {
    const Casters in(52, Casters::pointsAndSuns);
    const Rows points = askRay(
        in, "vec4((flattenAlongRay(a, b, c.xyz) / flattenAlongRay(a, b, c.xyz).w).xyz, 0.0)");
    Rows truth;
    for (std::size_t i = 0; i < in.planes.size(); ++i) {
        const dvec4 p = flattened(in.planes[i], in.lights[i], vec3(in.casters[i]));
        truth.emplace_back(p / p.w);
    }
    EXPECT_ROWS_NEAR(points, truth,
                     {.absolute = 1e-3,
                      .relative = 1e-4,
                      .components = 3,
                      .cause = "w from 0.1 on of coordinates up to 8, rounded to 2e-6: 2e-5 of "
                               "the ray, up to 100 long"});
}

TEST(Task5RayForm, FlattenedPointsAreLinearInTheCaster) {
    // Undivided, and in units of another caster's w: the rasteriser interpolates (p w, w), and its
    // sign tells what lies beyond the light.
    const Casters in(54, Casters::pointsAndSuns);
    const Rows flattenedPoints =
        askRay(in, "flattenAlongRay(a, b, d.xyz) / abs(flattenAlongRay(a, b, c.xyz).w)");
    Rows truth;
    for (std::size_t i = 0; i < in.planes.size(); ++i) {
        const dvec4 plane(in.planes[i]), light(in.lights[i]);
        truth.emplace_back(flattened(plane, light, vec3(in.others[i])) /
                           std::abs(flattened(plane, light, vec3(in.casters[i])).w));
    }
    EXPECT_ROWS_NEAR(flattenedPoints, truth,
                     {.absolute = 1e-3,
                      .relative = 1e-4,
                      .components = 4,
                      .cause = "products of up to 100, rounded to 1e-5, over w from 0.1 on"});
}

TEST(Task5RayForm, StaysAccurateAsTheCasterNearsTheLightsHeight) {
    const std::vector<double> gaps{1.0, 0.1, 0.01, 0.001};
    const NearTheLight in(gaps, 2048);
    const auto rays = in.errors("flattenAlongRay(a, b, c.xyz)");
    const auto matrices = in.errors(kMatrixForm);
    const std::array<double, 4> bounds{5e-7, 2e-6, 2e-5, 2e-4};
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const dvec2 ray = rays[i], matrix = matrices[i];
        const std::string gap = fmt::format("caster {} of the light's height below it: ", gaps[i]);
        EXPECT_VALUE(ray.x, LessOrEqual, 2 * bounds[i],
                     gap +
                         "a few roundings of 6e-8 in n·(l - v), which shrinks with the gap; twice "
                         "what was measured for other planes and lights");
        if (i > 0)
            EXPECT_VALUE(matrix.y / ray.y, GreaterOrEqual, 4,
                         gap + fmt::format("the matrix form's errors, {:.1e} on average and {:.1e} "
                                           "at most, are 7 to 10 times as large: it subtracts what "
                                           "is nearly equal after rounding",
                                           matrix.y, matrix.x));
    }
}

TEST(Task5RayForm, DrawsTheExactPolygon) {
    for (const bool directional : {false, true}) expectExactPolygon(kFloating, directional, 5, {});
    for (const std::vector<dvec3>& caster : {kThroughThePlane, kPastTheLight, kThroughBoth})
        expectExactPolygon(caster, false, 6, {});
}

TEST(Task5RayForm, StraddlingTrianglesKeepTheExactPolygonsArea) {
    for (const std::vector<dvec3>& caster : {kFloating, kThroughThePlane}) {
        const Scene scene = oneCaster(caster, false, 2);
        const Matrices m(scene);
        const Corners exact = between(m.planeVector, m.light, cornersOf(scene.meshes[1]));
        Rows planes, lights, corners;
        for (const dvec4 c : exact) {
            planes.emplace_back(m.planeVector), lights.emplace_back(m.light);
            corners.emplace_back(c);
        }
        Corners mine, truth;
        for (const vec4 c : evaluate({.chunk = "ray_form.glsl",
                            .expression = "flattenAlongRay(a, b, c.xyz)",
                            .inputs = {{"a", planes}, {"b", lights}, {"c", corners}}}))
            mine.emplace_back(c);
        for (const vec4 c : corners) truth.push_back(flattened(m.planeVector, m.light, vec3(c)));
        EXPECT_VALUE(std::abs(areaOf(mine) / areaOf(truth) - 1), LessOrEqual, 1e-6,
                     "a few roundings of 6e-8 in each corner");
    }
}

}  // namespace
}  // namespace penumbra
