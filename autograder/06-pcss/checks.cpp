// What soft shadows from one map must do: by closed form where there is one, by a twin of the
// formula on the program's own shadow map where the map's texels count, else by rays.
#include <algorithm>
#include <cmath>
#include <random>

#include "core/checks.h"
#include "core/metrics.h"
#include "core/truths.h"
#include "scene/gallery.h"
#include "scene/shapes.h"
#include "truth/closed_form.h"

namespace penumbra {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using Rows = std::vector<vec4>;

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
};

constexpr int kRows = 256;
constexpr glm::ivec2 kSmall{256, 256};
const std::string kRounding = "float32 products and sums of a few terms: 1e-5 relative";

// A perspective light view in float64: distances and depths, and what S is in it.
struct LightView {
    double nearPlane, farPlane, tangents, width;

    explicit LightView(Dice& dice)
        : nearPlane(dice(0.5, 5)),
          farPlane(nearPlane * dice(1.5, 6)),
          tangents(dice(0.5, 3)),
          width(dice(0.1, 3)) {}
    double distance(double t) const { return nearPlane + t * (farPlane - nearPlane); }
    double depth(double z) const { return farPlane / (farPlane - nearPlane) * (1 - nearPlane / z); }
    double scaleUv() const { return width * (1 / nearPlane - 1 / farPlane) / tangents; }
    // By similar triangles at the receiver, then seen from the light.
    double penumbraUv(double receiver, double blocker) const {
        return width * (receiver - blocker) / blocker / (receiver * tangents);
    }
};

// --- Task 1 ---

struct WidthRows {
    Rows scale, depths, search, penumbra;
};

WidthRows widthRows(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    WidthRows rows;
    for (int i = 0; i < kRows; ++i) {
        const LightView view(dice);
        const double receiver = view.distance(dice(0.05, 1));
        const double blocker =
            i % 8 == 0 ? receiver : view.nearPlane + dice(0, 0.9) * (receiver - view.nearPlane);
        const double aspect = dice(0.5, 2);  // the window need not be square
        rows.scale.emplace_back(dvec4(view.scaleUv(), aspect * view.scaleUv(), 0, 0));
        rows.depths.emplace_back(dvec4(view.depth(receiver), view.depth(blocker), 0, 0));
        const double search = view.penumbraUv(receiver, view.nearPlane);
        const double penumbra = view.penumbraUv(receiver, blocker);
        rows.search.emplace_back(dvec4(search, aspect * search, 0, 0));
        rows.penumbra.emplace_back(dvec4(penumbra, aspect * penumbra, 0, 0));
    }
    return rows;
}

// Depths near 1 are rounded to 6e-8, and a difference of two keeps that error; S is at most 10.
const RowTolerance kWidths{.absolute = 2e-6,
                           .relative = 1e-5,
                           .components = 2,
                           .cause = "depths are rounded to 6e-8 and S is at most 10; else float32"};

TEST(Task1Penumbra, SearchWindowHoldsABlockerOnTheNearPlane) {
    const WidthRows rows = widthRows(11);
    const Rows searchWidthUv = evaluate({.chunk = "penumbra.glsl",
                                         .expression = "vec4(searchWidthUv(a.xy, b.x), 0.0, 0.0)",
                                         .inputs = {{"a", rows.scale}, {"b", rows.depths}}});
    EXPECT_ROWS_NEAR(searchWidthUv, rows.search, kWidths);
}

TEST(Task1Penumbra, PenumbraFollowsSimilarTriangles) {
    const WidthRows rows = widthRows(12);
    const Rows penumbraWidthUv =
        evaluate({.chunk = "penumbra.glsl",
                  .expression = "vec4(penumbraWidthUv(a.xy, b.x, b.y), 0.0, 0.0)",
                  .inputs = {{"a", rows.scale}, {"b", rows.depths}}});
    EXPECT_ROWS_NEAR(penumbraWidthUv, rows.penumbra, kWidths);
}

TEST(Task1Penumbra, WidthsAreNeverNegative) {
    Dice dice{std::mt19937(13)};
    Rows scale, depths;
    for (int i = 0; i < kRows; ++i) {
        const double receiver = dice(-0.1, 0.5);
        scale.emplace_back(dvec4(dice(0.01, 1), dice(0.01, 1), 0, 0));
        depths.emplace_back(dvec4(std::min(receiver, 0.0), receiver, receiver + dice(0, 0.5), 0));
    }
    const Rows widths =
        evaluate({.chunk = "penumbra.glsl",
                  .expression = "vec4(searchWidthUv(a.xy, b.x), penumbraWidthUv(a.xy, b.y, b.z))",
                  .inputs = {{"a", scale}, {"b", depths}}});
    EXPECT_ROWS_NEAR(widths, Rows(kRows, vec4(0.0f)),
                     {.components = 4,
                      .cause = "receivers before the near plane, blockers behind the receiver"});
}

// --- Task 2 ---

// A receiver on a tilted plane, and points beside, over and under that plane, in light view space:
// the light's centre is the origin, it looks along -z.
struct PlaneRows {
    Rows height, scale, offset, over;
};

PlaneRows planeRows(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    PlaneRows rows;
    while (int(rows.over.size()) < kRows) {
        const LightView view(dice);
        const auto point = [&] {
            const double z = view.distance(dice(0.02, 1)), t = 0.5 * view.tangents;
            return dvec3(dice(-t, t) * z, dice(-t, t) * z, -z);
        };
        const dvec3 receiver = point(), other = point();
        const dvec3 normal = glm::normalize(dvec3(dice(-1, 1), dice(-1, 1), dice(-0.4, 1)));
        const double height = glm::dot(normal, other - receiver);
        if (std::abs(height) < 0.02 * glm::length(other - receiver)) continue;
        const auto uvDepth = [&](dvec3 p) {
            return dvec3(0.5 + p.x / -p.z / view.tangents, 0.5 + p.y / -p.z / view.tangents,
                         view.depth(-p.z));
        };
        rows.height.emplace_back(
            dvec4(-glm::dot(normal, receiver), view.width * normal.x, view.width * normal.y, 0));
        rows.scale.emplace_back(dvec4(view.scaleUv(), view.scaleUv(), 0, 0));
        rows.offset.emplace_back(dvec4(uvDepth(other) - uvDepth(receiver), 0));
        rows.over.emplace_back(height > 0 ? 1 : 0);
    }
    return rows;
}

TEST(Task2ReceiverPlane, TellsWhichPointsLieOverThePlane) {
    const PlaneRows rows = planeRows(21);
    const Rows overPlane =
        evaluate({.chunk = "receiver_plane.glsl",
                  .expression = "vec4(dot(receiverPlane(a.xyz, b.xy), c.xyz) > 0.0 ? 1.0 : 0.0)",
                  .inputs = {{"a", rows.height}, {"b", rows.scale}, {"c", rows.offset}}});
    EXPECT_ROWS_NEAR(overPlane, rows.over,
                     {.cause = "no point is nearer to the plane than 2 % of its distance"});
}

TEST(Task2ReceiverPlane, ABlockerIsBeforeTheReceiverAndOverItsPlane) {
    Dice dice{std::mt19937(22)};
    Rows planes, offsets, truth;
    while (int(truth.size()) < kRows) {
        const vec4 plane(dice(-2, 2), dice(-2, 2), dice(-2, 1), dice(0, 0.02));
        const vec4 offset(dice(-0.05, 0.05), dice(-0.05, 0.05), dice(-0.1, 0.05), 0);
        const double bias = plane.w;
        const double nearer = -double(offset.z) - bias;
        const double over =
            glm::dot(dvec3(plane), dvec3(offset)) - bias * std::abs(double(plane.z));
        if (std::min(std::abs(nearer), std::abs(over)) < 1e-4) continue;
        planes.push_back(plane);
        offsets.push_back(offset);
        truth.emplace_back(nearer > 0 && over > 0 ? 1 : 0);
    }
    const Rows isBlocker = evaluate({.chunk = "receiver_plane.glsl",
                                     .expression = "vec4(isBlocker(a.xyz, b.xyz, a.w) ? 1.0 : 0.0)",
                                     .inputs = {{"a", planes}, {"b", offsets}}});
    EXPECT_ROWS_NEAR(isBlocker, truth, {.cause = "no row is nearer to either border than 1e-4"});
}

TEST(Task2ReceiverPlane, TheHorizonCutsTheLight) {
    Dice dice{std::mt19937(23)};
    Rows heights, points, truth;
    while (int(truth.size()) < kRows) {
        const dvec3 height(dice(-1, 1), dice(-2, 2), dice(-2, 2));
        const dvec2 point(dice(-0.5, 0.5), dice(-0.5, 0.5));
        const double over = height.x + height.y * point.x + height.z * point.y;
        if (std::abs(over) < 1e-4) continue;
        heights.emplace_back(dvec4(height, 0));
        points.emplace_back(dvec4(point, 0, 0));
        truth.emplace_back(over > 0 ? 1 : 0);
    }
    const Rows isAboveHorizon =
        evaluate({.chunk = "receiver_plane.glsl",
                  .expression = "vec4(isAboveHorizon(a.xyz, b.xy) ? 1.0 : 0.0)",
                  .inputs = {{"a", heights}, {"b", points}}});
    EXPECT_ROWS_NEAR(isAboveHorizon, truth, {.cause = "no row is nearer to the horizon than 1e-4"});
}

// A plane that nothing blocks: what it sees of the light is what is above its horizon.
void expectHorizonOnly(const Scene& scene, const std::vector<std::string>& settings) {
    const Receivers receivers = TracedScene(scene, kSmall).receivers();
    Image truth(kSmall.x, kSmall.y, 1, 1.0f);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (receivers.hit[i])
            truth.pixels[i] = float(horizonVisibility(receivers.positions[i],
                                                      receivers.facetNormals[i], scene.lights[0]));
    const Rendered frame =
        render({.scene = sceneFile(scene), .size = kSmall, .settings = settings});
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth,
        {.outliers = 0,
         .outlierDistance = 0.1,
         .cause = scene.name + ": nothing stands before this plane; 8 x 8 samples cut by "
                               "its horizon are good to 1/16"});
}

// A wide light, half of it below the ground that it shines along: each receiver sees another share.
Scene settingLight() {
    Scene scene;
    scene.name = "setting light";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(6.0f, 1, 0)};
    scene.lights = {Light::lookingAt({1.0f, 0.5f, -6.0f}, {0.0f, -0.5f, 0.0f}, 3.0f)};
    scene.camera = {.eye = {0.0f, 4.0f, 6.0f},
                    .target = {0.0f, -0.2f, 0.0f},
                    .verticalFov = 0.8f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

TEST(Task2ReceiverPlane, NoFalseShadowOnAPlaneFrom10To89Degrees) {
    for (const char* scene : {"tilted@10", "tilted@60", "tilted@85", "tilted@89"})
        expectHorizonOnly(loadScene(scene), {"method=pcf", "pcf_radius=16", "kernel=grid"});
}

// --- Tasks 3 and 4: twins on the program's own map, without the receiver's plane ---

const ImageRequest kMatrix{"light_clip_from_world", {4, 4}};

// What the light's matrix says of the map: S and the bias of README §2, in float64.
struct MapView {
    double nearPlane, farPlane;
    dvec2 tangents, scaleUv;

    MapView(const Image& clipFromWorld, const Light& light) {
        glm::dmat4 m;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                m[column][row] = clipFromWorld.at(column, row);
        const glm::dmat4 p = m * glm::inverse(glm::dmat4(light.viewFromWorld()));
        nearPlane = p[3][2] / (p[2][2] - 1), farPlane = p[3][2] / (p[2][2] + 1);
        tangents = {2 / p[0][0], 2 / p[1][1]};
        scaleUv = double(light.width) * (1 / nearPlane - 1 / farPlane) / tangents;
    }
    // One texel, in depth.
    double bias(double depth, int mapSize) const {
        const double inverse = 1 / nearPlane + depth * (1 / farPlane - 1 / nearPlane);
        return std::max(tangents.x, tangents.y) / mapSize * inverse /
               (1 / nearPlane - 1 / farPlane);
    }
};

struct Map {
    const Image& depth;
    // OpenGL's rows run upwards.
    float operator()(vec2 uv) const {
        const int x = int(std::floor(uv.x * float(depth.width)));
        const int y = int(std::floor(uv.y * float(depth.height)));
        if (x < 0 || y < 0 || x >= depth.width || y >= depth.height) return 1.0f;
        return depth.at(x, depth.height - 1 - y);
    }
};

// n x n places around uv, in rows and columns.
template <typename Visit>
void visitGrid(vec2 uv, vec2 width, int n, Visit&& visit) {
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) visit(uv + ((vec2(i, j) + 0.5f) / float(n) - 0.5f) * width);
}

const std::vector<std::string> kBare{"receiver_plane=off", "horizon=off", "pyramid=off",
                                     "kernel=grid"};

std::vector<std::string> bare(std::vector<std::string> more) {
    more.insert(more.end(), kBare.begin(), kBare.end());
    return more;
}

TEST(Task3Pcf, ComparesFirstAndFiltersTheAnswers) {
    const std::string scene = "boxes@3";
    const Rendered frame =
        render({.scene = scene,
                .size = kSmall,
                .settings = bare({"method=pcf", "pcf_radius=5", "filter_samples=6"}),
                .images = {"visibility", "receiver", {"shadow_map", {512, 512}}, kMatrix}});
    const MapView view(frame.at("light_clip_from_world"), loadScene(scene).lights[0]);
    const Map map{frame.at("shadow_map")};
    const Image& receivers = frame.at("receiver");
    Image truth(kSmall.x, kSmall.y, 1), mask(kSmall.x, kSmall.y, 1);
    for (int y = 0; y < kSmall.y; ++y)
        for (int x = 0; x < kSmall.x; ++x) {
            if (receivers.at(x, y, 3) <= 0) continue;
            const float depth = receivers.at(x, y, 2);
            const double bias = view.bias(depth, 512);
            int lit = 0;
            visitGrid({receivers.at(x, y, 0), receivers.at(x, y, 1)}, vec2(10.0f / 512), 6,
                      [&](vec2 uv) { lit += !(depth - map(uv) > bias); });
            truth.at(x, y) = float(lit) / 36;
            mask.at(x, y) = 1;
        }
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth,
        {.outliers = 0.005,
         .outlierDistance = 0.01,
         .cause = "the same samples of the same map; a sample on a texel's border may "
                  "fall to either side: a share below 0.5 %"},
        mask);
}

TEST(Task4BlockerSearch, OnlyBlockersEnterTheMean) {
    const std::string scene = "stairs@3";
    const Rendered frame = render(
        {.scene = scene,
         .size = kSmall,
         .settings = bare({"search_samples=5"}),
         .images = {"blocker_depth", "search", "receiver", {"shadow_map", {512, 512}}, kMatrix}});
    const MapView view(frame.at("light_clip_from_world"), loadScene(scene).lights[0]);
    const Map map{frame.at("shadow_map")};
    const Image &receivers = frame.at("receiver"), &search = frame.at("search");
    Image truth(kSmall.x, kSmall.y, 1), mask(kSmall.x, kSmall.y, 1);
    double found = 0;
    for (int y = 0; y < kSmall.y; ++y)
        for (int x = 0; x < kSmall.x; ++x) {
            if (receivers.at(x, y, 3) <= 0) continue;
            const float depth = receivers.at(x, y, 2);
            const double bias = view.bias(depth, 512);
            double sum = 0, count = 0;
            visitGrid({receivers.at(x, y, 0), receivers.at(x, y, 1)},
                      vec2(view.scaleUv) * vec2(search.at(x, y, 0), search.at(x, y, 1)), 5,
                      [&](vec2 uv) {
                          if (depth - map(uv) > bias) sum += map(uv), count += 1;
                      });
            truth.at(x, y) = count > 0 ? float(sum / count) : 0;
            mask.at(x, y) = 1;
            found += search.at(x, y, 2) > 0;
        }
    EXPECT_VALUE(found, Greater, 1000, "receivers of this scene that find a blocker");
    EXPECT_IMAGE_NEAR(
        frame.at("blocker_depth"), truth,
        {.outliers = 0.01,
         .outlierDistance = 1e-4,
         .cause = "the same samples of the same map; a sample on a texel's border may "
                  "fall to either side: a share below 1 %"},
        mask);
}

// --- Task 5 ---

// rmse of `halfplane` against its formula, over receivers on the ground.
double halfPlaneError(int searchSamples, int filterSamples,
                      std::vector<std::string> settings = {}) {
    const Receivers receivers = TracedScene(loadScene("halfplane"), kSmall).receivers();
    settings.push_back("search_samples=" + std::to_string(searchSamples));
    settings.push_back("filter_samples=" + std::to_string(filterSamples));
    const Rendered frame = render({.scene = "halfplane", .size = kSmall, .settings = settings});
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
        const vec3 p = receivers.positions[i];
        if (!receivers.hit[i] || p.y > 0.01f) continue;
        const double error = frame.at("visibility").pixels[i] -
                             halfPlaneVisibility(p.x, kHalfPlaneBlockerHeight,
                                                 kHalfPlaneLightHeight, kHalfPlaneLightWidth);
        sum += error * error, count += 1;
    }
    return std::sqrt(sum / count);
}

TEST(Task5Pcss, AHalfPlanesPenumbraIsALinearRamp) {
    EXPECT_VALUE(halfPlaneError(5, 5), LessOrEqual, 0.012,
                 "25 samples at 25 places across the edge: steps of 1/25, an error of 1/25/√12");
    EXPECT_VALUE(halfPlaneError(8, 16), LessOrEqual, 0.002,
                 "256 samples at 256 places: what is left is the map's texel");
}

TEST(Task5Pcss, WithoutABlockerAllIsLit) {
    Scene scene;
    scene.name = "bare ground";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(4.0f, 1, 0)};
    scene.lights = {Light::lookingAt({1.0f, 7.0f, 0.5f}, {0.0f, 0.0f, 0.0f}, 1.0f)};
    scene.camera = {.eye = {0.0f, 3.0f, 6.0f},
                    .target = {0.0f, -0.4f, 0.0f},
                    .verticalFov = 0.85f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = kSmall,
                                   .images = {"visibility", "blocker_depth", "penumbra_width"}});
    const Image lit(kSmall.x, kSmall.y, 1, 1.0f), none(kSmall.x, kSmall.y, 1);
    EXPECT_IMAGE_NEAR(frame.at("visibility"), lit, {.maximum = 0, .cause = "nothing blocks"});
    EXPECT_IMAGE_NEAR(frame.at("blocker_depth"), none, {.maximum = 0, .cause = "nothing blocks"});
}

// `scene` with every length times `scale`.
Scene scaled(Scene scene, float scale) {
    for (Mesh& mesh : scene.meshes)
        for (vec3& p : mesh.positions) p *= scale;
    for (Light& light : scene.lights) light.center *= scale, light.width *= scale;
    Camera& camera = scene.camera;
    camera.eye *= scale, camera.target *= scale;
    camera.nearPlane *= scale, camera.farPlane *= scale;
    return scene;
}

TEST(Task5Pcss, ScalingTheWorldChangesNothing) {
    const Scene scene = loadScene("stairs@4");
    const Rendered one = render({.scene = sceneFile(scene), .size = kSmall});
    const Rendered sixteen = render({.scene = sceneFile(scaled(scene, 16.0f)), .size = kSmall});
    const Rendered sixteenth = render({.scene = sceneFile(scaled(scene, 0.0625f)), .size = kSmall});
    const char* cause = "a power of two changes no digit of a float";
    EXPECT_IMAGE_NEAR(sixteen.at("visibility"), one.at("visibility"),
                      {.maximum = 1e-6, .cause = cause});
    EXPECT_IMAGE_NEAR(sixteenth.at("visibility"), one.at("visibility"),
                      {.maximum = 1e-6, .cause = cause});
}

TEST(Task5Pcss, ATinyLightCastsAHardShadowAndAHugeOneStaysFinite) {
    const Image hard = TracedScene(loadScene("boxes@4"), kSmall).pointVisibility();
    const Rendered tiny =
        render({.scene = "boxes@4", .size = kSmall, .settings = {"light_size=0.001"}});
    EXPECT_VALUE(compareVisibility(tiny.at("visibility"), hard).rmse, LessOrEqual, 0.04,
                 "one texel along every edge, as for a hard shadow map of 512 texels");
    const Rendered huge =
        render({.scene = "boxes@4", .size = kSmall, .settings = {"light_size=4"}});
    const Image& visibility = huge.at("visibility");
    const auto [low, high] =
        std::minmax_element(visibility.pixels.begin(), visibility.pixels.end());
    EXPECT_VALUE(*low, GreaterOrEqual, 0, "a share");
    EXPECT_VALUE(*high, LessOrEqual, 1, "a share");
}

TEST(Task5Pcss, TheHorizonIsCountedOnce) {
    expectHorizonOnly(loadScene("tilted@85"), {});
    expectHorizonOnly(settingLight(), {});
}

// --- Task 6 ---

TEST(Task6MinPyramid, EveryTexelKnowsTheNearestOfItsWindow) {
    const std::string scene = "stairs@3";
    const Rendered frame =
        render({.scene = scene,
                .size = kSmall,
                .images = {{"min_depth", {0, 0}}, {"shadow_map", {512, 512}}, kMatrix}});
    const Image &nearest = frame.at("min_depth"), &map = frame.at("shadow_map");
    const dvec2 window =
        512.0 * MapView(frame.at("light_clip_from_world"), loadScene(scene).lights[0]).scaleUv;
    const int size = map.width / nearest.width;  // texels of the map in one of these
    const glm::ivec2 reach = size * glm::ivec2(glm::ceil(0.5 * window / double(size)));
    Image truth(nearest.width, nearest.height, 1, 1.0f);
    for (int y = 0; y < nearest.height; ++y)
        for (int x = 0; x < nearest.width; ++x)
            for (int v = std::max(size * y - reach.y, 0);
                 v < std::min(size * (y + 1) + reach.y, map.height); ++v)
                for (int u = std::max(size * x - reach.x, 0);
                     u < std::min(size * (x + 1) + reach.x, map.width); ++u)
                    truth.at(x, y) = std::min(truth.at(x, y), map.at(u, v));
    EXPECT_IMAGE_NEAR(nearest, truth,
                      {.maximum = 0, .cause = "the smallest of some depths is one of them"});
}

TEST(Task6MinPyramid, TheRadiusReachesTheWindowsEndsFromAnyPlace) {
    Dice dice{std::mt19937(61)};
    Rows rows, truth;
    while (int(truth.size()) < kRows) {
        const double texel = 1.0 / double(1 << int(dice(3, 9))), window = dice(0.01, 8) * texel;
        const double reach = 0.5 * window / texel;
        if (std::abs(reach - std::round(reach)) < 1e-3) continue;
        rows.emplace_back(dvec4(window, texel, 0, 0));
        truth.emplace_back(std::ceil(reach));
    }
    const Rows radius = evaluate({.chunk = "min_pyramid.glsl",
                                  .expression = "vec4(float(windowRadiusTexels(a.x, a.y)))",
                                  .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(radius, truth,
                     {.cause = "a whole number; no row is nearer to a step than 1e-3"});
}

TEST(Task6MinPyramid, TheNarrowedWindowHoldsEveryBlocker) {
    Dice dice{std::mt19937(62)};
    Rows widths, depths, truth;
    for (int i = 0; i < kRows; ++i) {
        const double scale = dice(0.01, 1), receiver = dice(0.1, 1);
        const double nearest = i % 4 == 0 ? receiver + dice(0, 0.2) : dice(0, receiver);
        const dvec2 s(scale, 1.5 * scale), width = s * receiver;
        widths.emplace_back(dvec4(width, s));
        depths.emplace_back(dvec4(receiver, nearest, 0, 0));
        truth.emplace_back(dvec4(s * std::max(receiver - nearest, 0.0), 0, 0));
    }
    const Rows narrowedWidthUv =
        evaluate({.chunk = "min_pyramid.glsl",
                  .expression = "vec4(narrowedWidthUv(a.xy, a.zw, b.x, b.y), 0.0, 0.0)",
                  .inputs = {{"a", widths}, {"b", depths}}});
    EXPECT_ROWS_NEAR(narrowedWidthUv, truth,
                     {.absolute = 1e-6,
                      .components = 2,
                      .cause = "a difference of depths that are rounded to 6e-8"});
}

// --- Task 7 ---

TEST(Task7Kernels, EverySampleHasARowAndAColumnOfItsOwn) {
    for (const int n : {3, 8}) {
        Rows cells, truth;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                cells.emplace_back(dvec4(i, j, 1.0 / n, 0));
                truth.emplace_back(dvec4(i + (j + 0.5) / n, j + (i + 0.5) / n, 0, 0) / double(n) -
                                   dvec4(0.5, 0.5, 0, 0));
            }
        const Rows shearedGrid = evaluate({.chunk = "kernels.glsl",
                                           .expression = "vec4(shearedGrid(a.xy, a.z), 0.0, 0.0)",
                                           .inputs = {{"a", cells}}});
        EXPECT_ROWS_NEAR(shearedGrid, truth, {.components = 2, .cause = kRounding});
    }
}

TEST(Task7Kernels, TheDiskKeepsAreasAndAxes) {
    Dice dice{std::mt19937(72)};
    Rows points, truth;
    const double pi = std::acos(-1.0);
    for (int i = 0; i < kRows; ++i) {
        const double axis[] = {0, dice(-0.5, 0.5)};
        const dvec2 p =
            i < 8 ? dvec2(axis[i % 2], axis[(i + 1) % 2]) : dvec2(dice(-0.5, 0.5), dice(-0.5, 0.5));
        points.emplace_back(dvec4(p, 0, 0));
        // The square through p becomes the circle of the same area; a side becomes a quarter turn.
        const double half = std::max(std::abs(p.x), std::abs(p.y)),
                     radius = 2 * half / std::sqrt(pi);
        const bool wide = std::abs(p.x) > std::abs(p.y);
        const double along = (wide ? p.y : p.x) / half * pi / 4;
        const double ahead = std::copysign(radius * std::cos(along), wide ? p.x : p.y);
        const double aside = radius * std::sin(along);
        truth.emplace_back(wide ? dvec4(ahead, aside, 0, 0) : dvec4(aside, ahead, 0, 0));
    }
    points.emplace_back(0.0f);
    truth.emplace_back(0.0f);
    const Rows diskFromSquare = evaluate({.chunk = "kernels.glsl",
                                          .expression = "vec4(diskFromSquare(a.xy), 0.0, 0.0)",
                                          .inputs = {{"a", points}}});
    EXPECT_ROWS_NEAR(diskFromSquare, truth,
                     {.absolute = 1e-4,
                      .components = 2,
                      .cause = "sine and cosine of a software rasteriser: 1e-4"});
}

// --- Task 8 and the bonus ---

void compareWithRays(const std::string& name, glm::ivec2 size,
                     const std::vector<std::string>& settings, double bound, double leak) {
    const Image truth = TracedScene(loadScene(name), size).areaVisibility(144);
    const Rendered frame = render({.scene = name, .size = size, .settings = settings});
    const Metrics m = compareVisibility(frame.at("visibility"), truth);
    EXPECT_VALUE(m.rmse, LessOrEqual, bound,
                 name + ": one blocker depth stands for all, one texel for what it holds");
    if (leak < 1)
        EXPECT_VALUE(
            m.lightLeakRate, LessOrEqual, leak,
            name + ": the share of the umbra's pixels that got more than a tenth of light");
}

constexpr glm::ivec2 kLarge{512, 512};

TEST(Task8WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@5", kLarge, {}, 0.022, 0.02); }
TEST(Task8WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@5", kLarge, {}, 0.084, 1); }
TEST(Task8WholeShadow, FoliageAgreesWithRays) {
    compareWithRays("foliage@5", kLarge, {}, 0.097, 1);
}
TEST(Task8WholeShadow, StairsAgreeWithRays) {
    compareWithRays("stairs@5", kLarge, {}, 0.034, 0.04);
}

TEST(Task9Backprojection, FenceAndStairsAgreeWithRays) {
    const std::vector<std::string> settings{"method=backprojection", "filter_samples=16"};
    compareWithRays("fence@5", kSmall, settings, 0.050, 1);
    compareWithRays("stairs@5", kSmall, settings, 0.040, 1);
}

TEST(Task9Backprojection, AHalfPlaneHidesALinearShare) {
    EXPECT_VALUE(halfPlaneError(4, 16, {"method=backprojection"}), LessOrEqual, 0.019,
                 "cells are at most a sixteenth of the light wide, and the edge cuts one of them: "
                 "1/16/√12 = 0.018 at worst, less where a cell is a texel");
}

TEST(Task9Backprojection, TheHorizonIsAClosedForm) {
    expectHorizonOnly(loadScene("tilted@85"), {"method=backprojection"});
    expectHorizonOnly(settingLight(), {"method=backprojection"});
}

}  // namespace
}  // namespace penumbra
