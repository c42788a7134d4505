// Planar shadows: the matrices, in closed form, and the polygons that they draw.
#include <glm/gtc/matrix_access.hpp>

#include "planar_checks.h"

namespace penumbra {
namespace {

Rows rowsOf(const dmat4& m) {
    Rows rows;
    for (int row = 0; row < 4; ++row) rows.emplace_back(glm::row(m, row));
    return rows;
}

const dvec4 kGround(0, 1, 0, 0);
const std::string kEntryRounding =
    "entries are sums of up to four float32 products; shown in units of |plane| |light|: 4 x 2^-24";

// Some scenes whose light lies anywhere; `anyPlane`: their plane, too, else it is the ground.
std::vector<Matrices> matricesOf(bool directional, bool anyPlane) {
    const int first = directional ? 22 : 21, count = anyPlane ? 5 : 2;
    Dice dice{std::mt19937(unsigned(first))};
    std::vector<Matrices> result;
    for (int i = 0; i < count; ++i) {
        const vec3 center(dice(-6, 6), dice(2, 9), dice(-6, 6));
        result.emplace_back(posed(stage(center, directional), anyPlane ? first + i : 0));
    }
    return result;
}

void expectEntries(const char* subject, const std::vector<Matrices>& all,
                   const std::function<dmat4(const Matrices&)>& mine,
                   const std::function<dmat4(const Matrices&)>& exact) {
    Rows measured, truth;
    for (const Matrices& m : all) {
        for (const vec4 row : rowsOf(mine(m) / m.scale())) measured.push_back(row);
        for (const vec4 row : rowsOf(exact(m) / m.scale())) truth.push_back(row);
    }
    expectRowsNear(subject, measured, truth,
                   {.absolute = 3e-7, .relative = 0, .components = 4, .cause = kEntryRounding});
}

// Random points between the plane and half the light's height, flattened by a matrix in float64.
void expectOnTheirRays(const char* subject, const Matrices& m, dvec4 plane, const dmat4& matrix) {
    Dice dice{std::mt19937(77)};
    const double lightHeight = m.light.w > 0 ? glm::dot(plane, m.light) : 8.0;
    Rows measured, truth;
    int behind = 0;
    while (truth.size() < 64) {
        const dvec3 v = dice.point(9.0);
        if (heightOver(plane, v) < 0 || heightOver(plane, v) > 0.5 * lightHeight) continue;
        const dvec4 p = matrix * dvec4(v, 1.0), exact = flattened(plane, m.light, v);
        behind += !(p.w > 0);
        measured.emplace_back(p / p.w);
        truth.emplace_back(exact / exact.w);
    }
    expectRowsNear(subject, measured, truth,
                   {.absolute = 2e-5,
                    .relative = 1e-5,
                    .components = 3,
                    .cause = "float32 entries at half the light's height: 2 x 4 x 2^-24 of "
                             "coordinates up to 20"});
    expectValue("points between plane and light with w <= 0", behind, Relation::Equal, 0,
                "w = n·(l - l_w v), positive below the light");
}

// --- Task 1 ---

TEST(Task1GroundMatrix, EntriesAreTheLecturesForAPointLight) {
    expectEntries(
        "groundShadowMatrix()", matricesOf(false, true), [](const Matrices& m) { return m.ground; },
        [](const Matrices& m) { return shadowMatrixOf(kGround, m.light); });
}

TEST(Task1GroundMatrix, ADirectionalLightTakesTheSameForm) {
    expectEntries(
        "groundShadowMatrix()", matricesOf(true, true), [](const Matrices& m) { return m.ground; },
        [](const Matrices& m) { return shadowMatrixOf(kGround, m.light); });
}

TEST(Task1GroundMatrix, FlattensPointsAlongTheirRays) {
    for (const bool directional : {false, true}) {
        const Matrices m = matricesOf(directional, false)[0];
        expectOnTheirRays("groundShadowMatrix() (v, 1)", m, kGround, m.ground);
    }
}

TEST(Task1GroundMatrix, DrawsTheExactPolygon) {
    for (const bool directional : {false, true})
        expectExactPolygon(kFloating, directional, 0, {"form=ground", "clip=off", "stencil=off"});
}

// --- Task 2 ---

TEST(Task2PlaneMatrix, EntriesForAnyPlaneAndAPointLight) {
    expectEntries(
        "planeShadowMatrix()", matricesOf(false, true), [](const Matrices& m) { return m.plane; },
        [](const Matrices& m) { return shadowMatrixOf(m.planeVector, m.light); });
}

TEST(Task2PlaneMatrix, ADirectionalLightTakesTheSameForm) {
    expectEntries(
        "planeShadowMatrix()", matricesOf(true, true), [](const Matrices& m) { return m.plane; },
        [](const Matrices& m) { return shadowMatrixOf(m.planeVector, m.light); });
}

TEST(Task2PlaneMatrix, EqualsTheGroundMatrixForTheGround) {
    for (const bool directional : {false, true})
        expectEntries(
            "planeShadowMatrix() for (0, 1, 0, 0)", matricesOf(directional, false),
            [](const Matrices& m) { return m.plane; },
            [](const Matrices& m) { return shadowMatrixOf(kGround, m.light); });
}

TEST(Task2PlaneMatrix, FlattensPointsAlongTheirRays) {
    for (const bool directional : {false, true})
        for (const Matrices& m : matricesOf(directional, true))
            expectOnTheirRays("planeShadowMatrix() (v, 1)", m, m.planeVector, m.plane);
}

TEST(Task2PlaneMatrix, DrawsTheExactPolygon) {
    for (const bool directional : {false, true})
        expectExactPolygon(kFloating, directional, 1, {"form=matrix", "clip=off", "stencil=off"});
}

TEST(Task2PlaneMatrix, KeepsTheExactPolygonsArea) {
    for (const std::vector<dvec3>& caster : {kFloating, kThroughThePlane}) {
        const Scene scene = oneCaster(caster, false, 2);
        const Matrices m(scene);
        Corners mine = between(m.planeVector, m.light, cornersOf(scene.meshes[1]));
        Corners exact = mine;
        for (dvec4& c : mine) c = m.plane * c;
        for (dvec4& c : exact) c = shadowMatrixOf(m.planeVector, m.light) * c;
        EXPECT_VALUE(std::abs(areaOf(mine) / areaOf(exact) - 1), LessOrEqual, 2e-6,
                     "float32 entries of 2^-24; the area holds two lengths and twice w");
    }
}

}  // namespace
}  // namespace penumbra
