// What planar shadows must do: closed form in float64 first, rays for whole pictures.
#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/matrix_access.hpp>

#include "core/checks.h"
#include "core/truths.h"
#include "planar_truth.h"
#include "scene/gallery.h"

namespace penumbra {
namespace {

using Rows = std::vector<vec4>;
using Settings = std::vector<std::string>;

constexpr int kRows = 256;
constexpr int kSize = 256;
const std::string kSnapping =
    "corners are snapped to 1/256 pixel: beyond 1/64 pixel from the polygon's edges every pixel "
    "is right";

// --- Matrices ---

dmat4 matrixFrom(const Image& image) {
    dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = image.at(column, row);
    return m;
}

Rows rowsOf(const dmat4& m) {
    Rows rows;
    for (int row = 0; row < 4; ++row) rows.emplace_back(glm::row(m, row));
    return rows;
}

// One frame's matrices, and what they were made from.
struct Matrices {
    dmat4 ground, plane;
    dvec4 planeVector, light;

    explicit Matrices(const Scene& scene) : light(scene.lights[0].position()) {
        const Rendered frame = render(
            {.scene = sceneFile(scene),
             .size = {16, 16},
             .images = {{"ground_matrix", {4, 4}}, {"shadow_matrix", {4, 4}}, {"plane", {4, 1}}}});
        ground = matrixFrom(frame.at("ground_matrix"));
        plane = matrixFrom(frame.at("shadow_matrix"));
        for (int i = 0; i < 4; ++i) planeVector[i] = frame.at("plane").at(i, 0);
    }
    // Of one entry before its terms cancel: float32 rounds relative to this.
    double scale() const { return glm::length(planeVector) * glm::length(light); }
};

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

// --- One caster's exact polygon ---

// Area on the plane of homogeneous corners, none of them at infinity.
double areaOf(const Corners& corners) {
    dvec3 twice(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const auto at = [&](std::size_t k) { return dvec3(corners[k]) / corners[k].w; };
        twice += glm::cross(at(i - 1) - at(0), at(i) - at(0));
    }
    return 0.5 * glm::length(twice);
}

const std::vector<dvec3> kFloating{{-1.0, 1.0, 0.9}, {1.4, 2.2, 0.2}, {0.1, 1.6, -1.2}};
const std::vector<dvec3> kThroughThePlane{{-1.2, -1.4, 0.4}, {1.6, 1.3, 0.9}, {0.3, 1.9, -1.3}};
const std::vector<dvec3> kPastTheLight{{-0.8, 0.9, 0.8}, {1.1, 7.5, 0.6}, {0.9, 1.2, -0.7}};
const std::vector<dvec3> kThroughBoth{{-1.5, -1.0, 0.5}, {1.3, 9.0, 0.7}, {0.8, 1.1, -0.9}};

Scene oneCaster(const std::vector<dvec3>& caster, bool directional, int pose) {
    Scene scene = stage({0.7f, 5.0f, -0.9f}, directional);
    scene.meshes.push_back(polygonMesh(caster));
    return posed(scene, pose);
}

// The receiver's part of a mask.
Image onReceiver(Image mask, const Image& receiver) {
    for (std::size_t i = 0; i < mask.pixels.size(); ++i)
        if (receiver.pixels[i] == 0.0f) mask.pixels[i] = 0.0f;
    return mask;
}

void expectExactPolygon(const std::vector<dvec3>& caster, bool directional, int pose,
                        const Settings& settings) {
    const Scene scene = oneCaster(caster, directional, pose);
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = {kSize, kSize},
                                   .settings = settings,
                                   .images = {"visibility", "receiver", {"plane", {4, 1}}}});
    dvec4 plane;
    for (int i = 0; i < 4; ++i) plane[i] = frame.at("plane").at(i, 0);
    const PolygonTruth truth =
        polygonTruth(plane, scene.lights[0].position(), cornersOf(scene.meshes[1]), scene.camera,
                     kSize, 1.0 / 64);
    EXPECT_IMAGE_NEAR(frame.at("visibility"), truth.visibility,
                      {.maximum = 1e-6, .cause = kSnapping},
                      onReceiver(truth.mask, frame.at("receiver")));
}

TEST(Task1GroundMatrix, DrawsTheExactPolygon) {
    for (const bool directional : {false, true})
        expectExactPolygon(kFloating, directional, 0, {"form=ground", "clip=off", "stencil=off"});
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

// --- Task 3 ---

// Rays from the receiver, and where they can be held to a pixel: farther than one from an edge of
// the shadow.
struct RayTruth {
    Receivers receivers;
    Image visibility, interior;

    RayTruth(const Scene& scene, glm::ivec2 size) {
        const TracedScene traced(scene, size);
        receivers = traced.receivers();
        visibility = traced.pointVisibility();
        interior = Image(size.x, size.y, 1, 1.0f);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int py = std::max(0, y - 1); py <= std::min(size.y - 1, y + 1); ++py)
                    for (int px = std::max(0, x - 1); px <= std::min(size.x - 1, x + 1); ++px)
                        if (visibility.at(px, py) != visibility.at(x, y)) interior.at(x, y) = 0.0f;
    }
};

// Of the receiver's pixels whose light is blocked, the share that came out dark. Where nothing is
// drawn, nothing is drawn in the wrong place either: that is no merit.
double darkShare(const Rendered& frame, const Image& truth) {
    double blocked = 0, dark = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (truth.pixels[i] == 0.0f && frame.at("receiver").pixels[i] != 0.0f)
            blocked += 1, dark += frame.at("visibility").pixels[i] < 0.5f;
    return dark / blocked;
}

// The matrix of task 2 draws before the tasks after this one are done.
const Settings kMatrixAlone{"form=matrix", "clip=off"};

// Five sheets one above another, and a box: its shadow has two layers everywhere.
Scene overlappingCasters() {
    Scene scene = stage({0.7f, 5.0f, -0.9f});
    for (int i = 0; i < 5; ++i) {
        const double x = 0.25 * i - 1.5, y = 0.6 + 0.45 * i, z = 0.2 * i - 0.8;
        scene.meshes.push_back(polygonMesh(
            {{x, y, z}, {x, y, z + 1.2}, {x + 1.2, y + 0.1, z + 1.2}, {x + 1.2, y + 0.1, z}}));
    }
    scene.meshes.push_back(box({1.2f, 0.4f, 0.5f}, {2.0f, 1.2f, 1.3f}, 0));
    return posed(scene, 3);
}

TEST(Task3Drawing, DarknessComesOnceUnderOverlappingCasters) {
    const Scene scene = overlappingCasters();
    const RayTruth rays(scene, {kSize, kSize});
    for (const float alpha : {0.25f, 0.5f, 1.0f}) {
        const Rendered frame =
            render({.scene = sceneFile(scene),
                    .size = {kSize, kSize},
                    .settings = {kMatrixAlone[0], kMatrixAlone[1], fmt::format("alpha={}", alpha)},
                    .images = {"visibility", "receiver"}});
        Image truth = rays.visibility;
        for (float& v : truth.pixels) v = v > 0 ? 1.0f : 1.0f - alpha;
        EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                          {.maximum = 1e-6,
                           .cause = fmt::format("one layer: visibility in shadow is 1 - {}, stored "
                                                "in float32",
                                                alpha)},
                          onReceiver(rays.interior, frame.at("receiver")));
    }
}

TEST(Task3Drawing, NoPixelFightsWithTheReceiver) {
    // The whole receiver but its rim is in shadow, seen at 4 degrees and from far away, where one
    // step of depth is largest.
    for (const int pose : {4, 5, 6}) {
        Scene scene = stage({0.3f, 9.0f, -0.4f});
        scene.meshes.push_back(
            polygonMesh({{-3, 0.5, -3}, {-3, 0.5, 3}, {3, 0.5, 3}, {3, 0.5, -3}}));
        scene.camera = {.eye = {5.0f, 4.0f, 60.0f},
                        .target = {0.0f, 0.0f, 0.0f},
                        .verticalFov = 0.12f,
                        .nearPlane = 0.1f,
                        .farPlane = 200.0f};
        scene = posed(scene, pose);
        const RayTruth rays(scene, {kSize, kSize});
        const Rendered frame = render({.scene = sceneFile(scene),
                                       .size = {kSize, kSize},
                                       .settings = kMatrixAlone,
                                       .images = {"visibility", "receiver"}});
        EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility,
                          {.maximum = 1e-6, .cause = "marks have no rounding"},
                          onReceiver(rays.interior, frame.at("receiver")));
    }
}

TEST(Task3Drawing, StopsAtTheReceiversEdge) {
    // The shadow of what stands on a table's edge would go on in the air.
    Scene scene = stage({-2.5f, 5.0f, 0.5f});
    scene.meshes[0] = ground(3.0f, 1, 0);
    scene.meshes[0].name = "receiver";
    scene.meshes.push_back(box({0.8f, 0.3f, -0.8f}, {1.3f, 1.8f, 0.9f}, 0));
    scene = posed(scene, 7);
    const RayTruth rays(scene, {kSize, kSize});
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = {kSize, kSize},
                                   .settings = kMatrixAlone,
                                   .images = {"visibility", "receiver"}});
    Image mask = onReceiver(rays.interior, frame.at("receiver"));
    for (std::size_t i = 0; i < mask.pixels.size(); ++i)
        if (!rays.receivers.hit[i]) mask.pixels[i] = 1.0f;
    EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility,
                      {.maximum = 1e-6,
                       .cause = "background everywhere, and the receiver farther than a pixel from "
                                "a shadow's edge"},
                      mask);
}

TEST(Task3Drawing, NothingIsDrawnOverCasters) {
    for (const char* name : {"boxes@2", "fence@2"}) {
        const Scene scene = loadScene(name);
        const RayTruth rays(scene, {kSize, kSize});
        const Rendered frame = render({.scene = name,
                                       .size = {kSize, kSize},
                                       .settings = kMatrixAlone,
                                       .images = {"visibility", "receiver"}});
        // Casters bear attached shadow alone: dark where they face away.
        const vec3 light = scene.lights[0].center;
        Image truth(kSize, kSize, 1, 1.0f), mask(kSize, kSize, 1);
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            if (!rays.receivers.hit[i] || frame.at("receiver").pixels[i] != 0.0f) continue;
            const double cosine =
                glm::dot(dvec3(rays.receivers.facetNormals[i]),
                         glm::normalize(dvec3(light - rays.receivers.positions[i])));
            truth.pixels[i] = cosine > 0 ? 1.0f : 0.0f;
            // Within 3 degrees of its horizon, or where two facets share the pixel, derivatives of
            // the position decide.
            mask.pixels[i] = std::abs(cosine) > 0.05;
        }
        EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                          {.outliers = 0.002,
                           .cause = std::string(name) + ": facets' edges, along which the pixel's "
                                                        "derivatives mix two facets"},
                          mask);
        EXPECT_VALUE(
            darkShare(frame, rays.visibility), GreaterOrEqual, 0.4,
            std::string(name) + ": on the receiver there is a shadow, if only a striped one");
    }
}

// --- Task 4 ---

// Planes and lights on their lit side, and casters anywhere; none nearer than 0.1 to a boundary, so
// that rounding decides nothing.
struct Casters {
    Rows planes, lights, casters, others;

    enum Lights { points, pointsAndSuns };

    Casters(unsigned seed, Lights kinds) {
        Dice dice{std::mt19937(seed)};
        add(dice, false);
        if (kinds == pointsAndSuns) add(dice, true);
    }
    void add(Dice& dice, bool directional) {
        for (const std::size_t end = planes.size() + kRows; planes.size() < end;) {
            const dvec4 plane(vec4(vec3(dice.direction()), float(dice(-3, 3))));
            const dvec4 light(directional ? vec3(dice.direction()) : vec3(dice.point(8)),
                              directional ? 0 : 1);
            const dvec3 caster(vec3(dice.point(8))), other(vec3(dice.point(8)));
            const double most = glm::dot(plane, light);
            if (most < (directional ? 0.1 : 1.0)) continue;
            if (!decided(plane, light, caster) || !decided(plane, light, other)) continue;
            planes.emplace_back(plane), lights.emplace_back(light);
            casters.emplace_back(caster, 1), others.emplace_back(other, 1);
        }
    }
    static bool decided(dvec4 plane, dvec4 light, dvec3 caster) {
        const double height = heightOver(plane, caster);
        const double room = glm::dot(plane, light) - light.w * height;
        return std::abs(height) > 0.1 && std::abs(room) > 0.1;
    }
    Rows ask(const char* chunk, const char* expression) const {
        return evaluate({.chunk = chunk,
                         .expression = expression,
                         .inputs = {{"a", planes}, {"b", lights}, {"c", casters}, {"d", others}}});
    }
};

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

// The receiver against the rays, farther than a pixel from a shadow's edge.
void expectLikeRays(const Scene& scene, const Settings& settings, const std::string& cause) {
    const RayTruth rays(scene, {kSize, kSize});
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = {kSize, kSize},
                                   .settings = settings,
                                   .images = {"visibility", "receiver"}});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility, {.maximum = 1e-6, .cause = cause},
                      onReceiver(rays.interior, frame.at("receiver")));
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

// Casters at one of four gaps below the light, in its height, up to 3 beside it.
struct NearTheLight {
    static constexpr std::array<double, 4> kGaps{1.0, 0.1, 0.01, 0.001};
    static constexpr int kCasters = 2048;  // for each gap
    Rows planes, lights, casters;

    NearTheLight() {
        for (const double gap : kGaps) {
            Dice dice{std::mt19937(55)};
            for (int i = 0; i < kCasters; ++i) add(dice, gap);
        }
    }
    void add(Dice& dice, double gap) {
        const dvec4 plane(vec4(vec3(dice.direction()), float(dice(-3, 3))));
        const dvec3 n(plane);
        const auto beside = [&](double distance) {
            return distance * glm::normalize(glm::cross(n, dice.direction()));
        };
        const double height = dice(2, 9);
        const dvec3 light(vec3((height - plane.w) * n + beside(dice(0, 3))));
        planes.emplace_back(plane), lights.emplace_back(light, 1);
        casters.emplace_back(light - gap * height * n + beside(dice(0.5, 3)), 1);
    }
    // By gap: largest and root mean square of |p - exact p| over the length of the ray.
    std::array<dvec2, 4> errors(const char* expression) const {
        const Rows rows = evaluate({.chunk = "ray_form.glsl",
                                    .expression = expression,
                                    .inputs = {{"a", planes}, {"b", lights}, {"c", casters}}});
        std::array<dvec2, 4> result{};
        for (std::size_t i = 0; i < rows.size(); ++i) {
            dvec2& of = result[i / kCasters];
            const dvec4 exact = flattened(planes[i], lights[i], vec3(casters[i]));
            const dvec3 p = dvec3(exact) / exact.w, mine = dvec3(vec3(rows[i])) / double(rows[i].w);
            const double e = glm::distance(mine, p) / glm::distance(dvec3(vec3(lights[i])), p);
            if (!(e <= of.x)) of.x = e;  // NaN, too
            of.y += e * e;
        }
        for (dvec2& of : result) of.y = std::sqrt(of.y / kCasters);
        return result;
    }
};

TEST(Task5RayForm, StaysAccurateAsTheCasterNearsTheLightsHeight) {
    const NearTheLight in;
    const auto rays = in.errors("flattenAlongRay(a, b, c.xyz)");
    const auto matrices = in.errors("(dot(a, b) * mat4(1.0) - outerProduct(b, a)) * c");
    const std::array<double, 4> bounds{5e-7, 2e-6, 2e-5, 2e-4};
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const dvec2 ray = rays[i], matrix = matrices[i];
        const std::string gap =
            fmt::format("caster {} of the light's height below it: ", NearTheLight::kGaps[i]);
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

// --- Task 6 ---

TEST(Task6ShadowTexture, UvRunsFromZeroToOne) {
    Dice dice{std::mt19937(61)};
    Rows clip, truth;
    for (int i = 0; i < kRows; ++i) {
        const double w = dice(0.1, 9);
        clip.emplace_back(dice(-1, 1) * w, dice(-1, 1) * w, 0, w);
        truth.emplace_back(0.5 * clip.back().x / clip.back().w + 0.5,
                           0.5 * clip.back().y / clip.back().w + 0.5, 0, 0);
    }
    const Rows shadowTextureUv = evaluate({.chunk = "shadow_texture.glsl",
                                           .expression = "vec4(shadowTextureUv(a), 0.0, 0.0)",
                                           .inputs = {{"a", clip}}});
    EXPECT_ROWS_NEAR(
        shadowTextureUv, truth,
        {.components = 2, .cause = "a quotient and a sum in float32: 1e-5 of it, 1e-6 near 0"});
}

// `texels` in x and clip positions; the answer is the visibility.
Rows askTexture(const Rows& texels, const Rows& clip) {
    return evaluate({.chunk = "shadow_texture.glsl",
                     .expression = "vec4(shadowTextureVisibility(a.x, b))",
                     .inputs = {{"a", texels}, {"b", clip}}});
}

TEST(Task6ShadowTexture, InsideTheTexelDecides) {
    Dice dice{std::mt19937(62)};
    Rows texels, clip;
    for (int i = 0; i < kRows; ++i) {
        const double w = dice(0.1, 9);
        texels.emplace_back(float(i % 3 < 2 ? i % 3 : dice(0, 1)));
        clip.emplace_back(dice(-0.99, 0.99) * w, dice(-0.99, 0.99) * w, 0, w);
    }
    const Rows shadowTextureVisibility = askTexture(texels, clip);
    EXPECT_ROWS_NEAR(shadowTextureVisibility, texels,
                     {.absolute = 0, .relative = 1e-6, .cause = "the texel as it is"});
}

TEST(Task6ShadowTexture, BesideTheTextureIsLight) {
    Dice dice{std::mt19937(63)};
    Rows texels, clip, truth;
    for (int i = 0; i < kRows; ++i) {
        const double w = dice(0.1, 9), sign = i % 2 ? w : -w;
        const double u = sign * dice(0, 0.99), v = dice(-0.99, 0.99) * w;
        const double beyond = sign * dice(1.01, 4);
        texels.emplace_back(float(dice(0, 0.9)));
        clip.emplace_back(i % 3 == 0   ? dvec4(u, v, 0, w)  // inside, for comparison
                          : i % 3 == 1 ? dvec4(beyond, v, 0, w)
                                       : dvec4(v, beyond, 0, w));
        truth.push_back(i % 3 == 0 ? texels.back() : vec4(1.0f));
    }
    const Rows shadowTextureVisibility = askTexture(texels, clip);
    EXPECT_ROWS_NEAR(shadowTextureVisibility, truth,
                     {.absolute = 0,
                      .relative = 1e-6,
                      .cause = "the background goes on, whatever the border's texel holds"});
}

TEST(Task6ShadowTexture, BehindTheLightIsLight) {
    Dice dice{std::mt19937(64)};
    Rows texels, clip, truth;
    for (int i = 0; i < kRows; ++i) {
        const double w = i % 16 == 0 ? 0 : dice(0.1, 9), before = i % 3 == 0 ? 1 : -1;
        texels.emplace_back(float(dice(0, 0.9)));
        clip.emplace_back(dice(-0.99, 0.99) * w, dice(-0.99, 0.99) * w, 0, before * w);
        truth.push_back(clip.back().w > 0 ? texels.back() : vec4(1.0f));
    }
    const Rows shadowTextureVisibility = askTexture(texels, clip);
    EXPECT_ROWS_NEAR(shadowTextureVisibility, truth,
                     {.absolute = 0,
                      .relative = 1e-6,
                      .cause = "q <= 0: the quotient would mirror what is on the other side"});
}

// The texture's view with a depth, which the edge band needs.
glm::mat4 withDepth(dmat4 clipFromWorld, const Light& light) {
    const dvec4 distance = light.directional ? dvec4(1e-3 * dvec3(light.forward()), 0)
                                             : glm::row(clipFromWorld, 3) - dvec4(0, 0, 0, 0.01);
    return glm::mat4(glm::row(clipFromWorld, 2, distance));
}

// The receiver against the rays, farther than 1.5 texels from a shadow's edge; `share` of the rest
// may be wrong.
void expectTextureLikeRays(const Scene& scene, const std::string& file, const Settings& settings,
                           double share, const std::string& cause) {
    constexpr int kTexels = 1024;
    const Light& light = scene.lights[0];
    const TracedScene traced(scene, {kSize, kSize});
    const Rendered frame =
        render({.scene = file,
                .size = {kSize, kSize},
                .settings = settings,
                .images = {"visibility", "receiver", {"texture_clip_from_world", {4, 4}}}});
    const glm::mat4 clip = withDepth(matrixFrom(frame.at("texture_clip_from_world")), light);
    Image mask = traced.edgeBand(clip, kTexels, 1.5f);
    for (float& v : mask.pixels) v = 1.0f - v;
    EXPECT_IMAGE_NEAR(frame.at("visibility"), traced.pointVisibility(),
                      {.outliers = share, .outlierDistance = 0.01, .cause = cause},
                      onReceiver(mask, frame.at("receiver")));
}

// A ball as receiver: it has no plane, and shadows itself by facing away alone. A box and a
// triangle float above.
Scene ballAsReceiver(bool directional) {
    Scene scene = stage({1.5f, 6.0f, -1.0f}, directional);
    scene.meshes[0] = sphere({0.0f, -2.0f, 0.0f}, 3.0f, 64, 0);
    scene.meshes[0].name = "receiver";
    scene.meshes.push_back(box({0.6f, 2.2f, -0.9f}, {1.3f, 2.9f, -0.2f}, 0));
    scene.meshes.push_back(polygonMesh({{-2.2, 2.0, 0.2}, {-0.9, 2.4, 1.6}, {-0.6, 2.1, -0.4}}));
    return scene;
}

TEST(Task6ShadowTexture, CurvedReceiverAgreesWithRays) {
    for (const bool directional : {false, true}) {
        const Scene scene = posed(ballAsReceiver(directional), 3);
        expectTextureLikeRays(scene, sceneFile(scene), {}, 0,
                              "a ball: farther than 1.5 texels from a shadow's edge");
    }
}

TEST(Task6ShadowTexture, NoMirroredShadowBehindTheLight) {
    // The light hangs low. The texture looks at a caster on one side, part of which is above the
    // light; the receiver has two sides, and on the other one nothing is in shadow.
    Scene scene = stage({0.0f, 1.5f, 0.0f});
    scene.meshes.push_back(polygonMesh({{1.0, 1.1, -0.6}, {1.9, 0.8, 0.3}, {1.5, 2.9, 0.4}}));
    scene = posed(scene, 5);
    const RayTruth rays(scene, {kSize, kSize});
    const Rendered frame =
        render({.scene = sceneFile(scene),
                .size = {kSize, kSize},
                .settings = {"method=texture"},
                .images = {"visibility", "receiver", {"texture_clip_from_world", {4, 4}}}});
    const dmat4 clip = matrixFrom(frame.at("texture_clip_from_world"));
    Image behind(kSize, kSize, 1);
    for (std::size_t i = 0; i < behind.pixels.size(); ++i)
        behind.pixels[i] = frame.at("receiver").pixels[i] != 0.0f &&
                           (clip * dvec4(rays.receivers.positions[i], 1.0)).w < -0.01;
    EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility,
                      {.maximum = 0, .cause = "receivers at least 0.01 behind: no texel is asked"},
                      behind);
    EXPECT_VALUE(darkShare(frame, rays.visibility), GreaterOrEqual, 0.8,
                 "before the light there is the caster's shadow, but for texels on its edge");
}

// --- Task 7 ---

// A gallery scene: how many receivers are wrong at all, and farther than a pixel from an edge.
void compareWithRays(const std::string& name, int allowed) {
    constexpr glm::ivec2 kLarge{512, 512};
    const RayTruth rays(loadScene(name), kLarge);
    const Rendered frame =
        render({.scene = name, .size = kLarge, .images = {"visibility", "receiver"}});
    const Image& visibility = frame.at("visibility");
    int wrong = 0;
    for (std::size_t i = 0; i < visibility.pixels.size(); ++i)
        wrong += frame.at("receiver").pixels[i] != 0.0f &&
                 std::abs(visibility.pixels[i] - rays.visibility.pixels[i]) > 0.5f;
    EXPECT_VALUE(wrong, LessOrEqual, allowed,
                 name + ": pixels whose centre lies within rounding of a shadow's edge");
    EXPECT_IMAGE_NEAR(visibility, rays.visibility,
                      {.maximum = 1e-6, .cause = name + ": farther than a pixel from an edge"},
                      onReceiver(rays.interior, frame.at("receiver")));
}

TEST(Task7WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@5", 10); }
TEST(Task7WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@5", 25); }
TEST(Task7WholeShadow, StairsAgreeWithRays) { compareWithRays("stairs@5", 10); }
TEST(Task7WholeShadow, FoliageAgreesWithRays) {
    expectTextureLikeRays(loadScene("foliage@5"), "foliage@5", {}, 0.001,
                          "hills under leaves: shadows thinner than half a texel slip through the "
                          "mask");
}

TEST(Task7WholeShadow, LowLightsCastLongShadows) {
    for (const float height : {0.5f, 0.15f, 0.0f}) {
        Scene scene = stage({-8.0f, height, 1.0f});
        scene.meshes.push_back(box({-2.0f, 0.0f, -1.0f}, {-1.8f, 0.1f + 0.4f * height, 0.2f}, 0));
        // A light in the plane itself is posed there exactly in pose 0 alone.
        expectLikeRays(posed(scene, height > 0 ? 6 : 0), {},
                       fmt::format("a light {} above the plane, 8 away", height));
    }
}

TEST(Task7WholeShadow, HugeAndTinyScenesCastTheSameShadow) {
    const Scene scene = overlappingCasters();
    const RayTruth rays(scene, {kSize, kSize});
    for (const int exponent : {-10, 10}) {
        const Rendered frame =
            render({.scene = sceneFile(scaled(scene, std::ldexp(1.0f, exponent))),
                    .size = {kSize, kSize},
                    .images = {"visibility", "receiver"}});
        EXPECT_IMAGE_NEAR(
            frame.at("visibility"), rays.visibility,
            {.maximum = 1e-6,
             .cause = fmt::format("the scene times 2^{}: floats scale exactly", exponent)},
            onReceiver(rays.interior, frame.at("receiver")));
    }
}

}  // namespace
}  // namespace penumbra
