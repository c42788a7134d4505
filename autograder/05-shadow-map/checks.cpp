// What a shadow map must do, by closed form where there is one, else by rays.
#include <algorithm>
#include <cmath>
#include <random>

#include "core/checks.h"
#include "core/metrics.h"
#include "core/truths.h"
#include "scene/gallery.h"
#include "scene/shapes.h"

namespace penumbra {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec3;
using glm::vec4;
using Rows = std::vector<vec4>;

// --- Inputs and truths of single functions ---

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
};

constexpr int kRows = 256;
const std::string kRounding = "float32 products and sums of a few terms: 1e-5 relative";

Rows makeRows(int count, const std::function<dvec4()>& row) {
    Rows rows;
    for (int i = 0; i < count; ++i) rows.emplace_back(row());
    return rows;
}

// --- Frames and their truth ---

glm::dmat4 matrixFrom(const Image& image) {
    glm::dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = image.at(column, row);
    return m;
}

// The light's view as its matrix tells it: tangents and distances (README §1).
struct Frustum {
    double left, right, bottom, top, nearPlane, farPlane;
};

Frustum frustumOf(const glm::dmat4& lightClipFromWorld, const Light& light) {
    const glm::dmat4 p = lightClipFromWorld * glm::inverse(glm::dmat4(light.viewFromWorld()));
    return {(p[2][0] - 1) / p[0][0], (p[2][0] + 1) / p[0][0], (p[2][1] - 1) / p[1][1],
            (p[2][1] + 1) / p[1][1], p[3][2] / (p[2][2] - 1), p[3][2] / (p[2][2] + 1)};
}

// 1 where the map can be held to the rays pixel by pixel: farther than `texels` from a shadow's
// edge.
Image interior(const TracedScene& truth, const Image& lightClipFromWorld, int mapSize,
               float texels) {
    Image mask = truth.edgeBand(glm::mat4(matrixFrom(lightClipFromWorld)), mapSize, texels);
    for (float& v : mask.pixels) v = 1.0f - v;
    return mask;
}

const ImageRequest kMatrix{"light_clip_from_world", {4, 4}};
constexpr glm::ivec2 kSmall{256, 256};

// A ground of 4 x 4 that the camera sees whole, and a small blocker in the light's way that it does
// not see.
Scene groundAndBlocker() {
    Scene scene;
    scene.name = "ground and blocker";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(4.0f, 1, 0), quad({0.2f, 4.0f, 0.0f}, {0.2f, 4.0f, 0.5f},
                                             {0.7f, 4.0f, 0.5f}, {0.7f, 4.0f, 0.0f}, 0)};
    scene.lights = {Light::lookingAt({1.0f, 7.0f, 0.5f}, {0.0f, 0.0f, 0.0f}, 0.5f)};
    scene.camera = {.eye = {0.0f, 3.0f, 6.0f},
                    .target = {0.0f, -0.4f, 0.0f},
                    .verticalFov = 0.85f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

// The light stands low over the ground's middle and shines along it: half of the ground is behind
// it.
Scene lowLight() {
    Scene scene;
    scene.name = "low light";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(8.0f, 1, 0), box({1.5f, 0.0f, -0.5f}, {2.0f, 0.8f, 0.5f}, 0)};
    scene.lights = {Light::lookingAt({0.0f, 1.5f, 0.0f}, {2.0f, 0.9f, 0.0f}, 0.2f)};
    scene.camera = {.eye = {0.0f, 7.0f, 6.0f},
                    .target = {0.0f, 0.0f, 0.0f},
                    .verticalFov = 0.9f,
                    .nearPlane = 1.0f,
                    .farPlane = 30.0f};
    return scene;
}

std::vector<dvec3> inLightView(const Light& light, const std::vector<vec3>& points) {
    std::vector<dvec3> result;
    for (const vec3 p : points)
        result.emplace_back(glm::dmat4(light.viewFromWorld()) * dvec4(p, 1.0));
    return result;
}

Frustum fittedFrustum(const Scene& scene) {
    const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall, .images = {kMatrix}});
    return frustumOf(matrixFrom(frame.at("light_clip_from_world")), scene.lights[0]);
}

// --- Task 1 ---

TEST(Task1LightFrustum, HoldsEveryReceiverThatTheCameraSees) {
    for (const char* name : {"boxes@2", "fence@3", "stairs@2"}) {
        const Receivers receivers = TracedScene(loadScene(name), kSmall).receivers();
        const Rendered frame = render({.scene = name, .size = kSmall, .images = {kMatrix}});
        const glm::dmat4 m = matrixFrom(frame.at("light_clip_from_world"));
        int outside = 0;
        for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
            if (!receivers.hit[i]) continue;
            const dvec4 clip = m * dvec4(receivers.positions[i], 1.0);
            const double room =
                1.0001 * clip.w;  // a receiver on a side of the window, rounded in float32
            outside +=
                !(std::abs(clip.x) <= room && std::abs(clip.y) <= room && std::abs(clip.z) <= room);
        }
        EXPECT_VALUE(outside, Equal, 0,
                     "receivers of " + std::string(name) + " that rays hit and the frustum misses");
    }
}

TEST(Task1LightFrustum, TouchesItsReceiversOnAllFourSides) {
    const Scene scene = groundAndBlocker();
    const Frustum fitted = fittedFrustum(scene);
    Frustum exact{1e9, -1e9, 1e9, -1e9, 0, 0};
    for (const dvec3 p : inLightView(scene.lights[0], scene.meshes[0].positions)) {
        exact.left = std::min(exact.left, p.x / -p.z),
        exact.right = std::max(exact.right, p.x / -p.z);
        exact.bottom = std::min(exact.bottom, p.y / -p.z),
        exact.top = std::max(exact.top, p.y / -p.z);
    }
    const char* cause = "the ground's corners are the outermost receivers; float32 matrices: 1e-4";
    EXPECT_VALUE(std::abs(fitted.left - exact.left), LessOrEqual, 1e-4, cause);
    EXPECT_VALUE(std::abs(fitted.right - exact.right), LessOrEqual, 1e-4, cause);
    EXPECT_VALUE(std::abs(fitted.bottom - exact.bottom), LessOrEqual, 1e-4, cause);
    EXPECT_VALUE(std::abs(fitted.top - exact.top), LessOrEqual, 1e-4, cause);
}

TEST(Task1LightFrustum, LeavesOutWhatIsBehindTheLight) {
    const Scene scene = lowLight();
    const Frustum fitted = fittedFrustum(scene);
    const Receivers receivers = TracedScene(scene, kSmall).receivers();
    int outside = 0;
    for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
        const dvec3 p =
            dvec3(glm::dmat4(scene.lights[0].viewFromWorld()) * dvec4(receivers.positions[i], 1.0));
        const double x = p.x / -p.z, y = p.y / -p.z, room = 1e-3;
        if (!receivers.hit[i] || p.z >= -1e-3 || std::max(std::abs(x), std::abs(y)) > 5.99)
            continue;
        outside += x < fitted.left - room || x > fitted.right + room || y < fitted.bottom - room ||
                   y > fitted.top + room;
    }
    EXPECT_VALUE(outside, Equal, 0,
                 "receivers in front of the light, within its widest view, and not in the window");
    double top = -1e9;  // of all that stands in front; the same sum over what is behind comes out
                        // above the axis
    for (const Mesh& mesh : scene.meshes)
        for (const dvec3 p : inLightView(scene.lights[0], mesh.positions))
            if (p.z < 0) top = std::max(top, p.y / -p.z);
    EXPECT_VALUE(fitted.top, LessOrEqual, top + 1e-3,
                 "the highest vertex in front of the light; float32 matrices");
}

TEST(Task1LightFrustum, NearPlaneStopsAtTheNearestBlocker) {
    const Scene scene = groundAndBlocker();
    const Frustum fitted = fittedFrustum(scene);
    double nearest = 1e9;
    for (const dvec3 p : inLightView(scene.lights[0], scene.meshes[1].positions))
        nearest = std::min(nearest, -p.z);
    EXPECT_VALUE(fitted.nearPlane, LessOrEqual, nearest,
                 "a blocker before the near plane is cut away, and its shadow with it");
    EXPECT_VALUE(fitted.nearPlane, GreaterOrEqual, 0.995 * nearest,
                 "0.1 % of room is asked for; 0.5 % is let pass");
}

TEST(Task1LightFrustum, FarPlaneStopsAtTheFarthestReceiver) {
    const Scene scene = groundAndBlocker();
    const Frustum fitted = fittedFrustum(scene);
    double farthest = 0;
    for (const dvec3 p : inLightView(scene.lights[0], scene.meshes[0].positions))
        farthest = std::max(farthest, -p.z);
    EXPECT_VALUE(fitted.farPlane, GreaterOrEqual, farthest * (1 - 1e-5), "float32 matrices: 1e-5");
    EXPECT_VALUE(fitted.farPlane, LessOrEqual, 1.005 * farthest,
                 "0.1 % of room is asked for; 0.5 % is let pass");
}

// --- Task 2 ---

TEST(Task2ShadowCoordinates, LightClipPositionProjectsThePoint) {
    Dice dice{std::mt19937(21)};
    std::map<std::string, Rows> inputs;
    for (const char* column : {"a", "b", "c", "d"})
        inputs[column] = makeRows(
            kRows, [&] { return dvec4(dice(-2, 2), dice(-2, 2), dice(-2, 2), dice(-2, 2)); });
    inputs["p"] = makeRows(kRows, [&] { return dvec4(dice(-9, 9), dice(-9, 9), dice(-9, 9), 0); });
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const dvec4 p = inputs["p"][i];
        truth.emplace_back(dvec4(inputs["a"][i]) * p.x + dvec4(inputs["b"][i]) * p.y +
                           dvec4(inputs["c"][i]) * p.z + dvec4(inputs["d"][i]));
    }
    const Rows lightClipPosition =
        evaluate({.chunk = "shadow_coordinates.glsl",
                  .expression = "lightClipPosition(p.xyz, mat4(a, b, c, d))",
                  .inputs = inputs});
    EXPECT_ROWS_NEAR(
        lightClipPosition, truth,
        {.absolute = 2e-5, .components = 4, .cause = "sums of four products up to 18 in float32"});
}

TEST(Task2ShadowCoordinates, UvAndDepthRunFromZeroToOne) {
    Dice dice{std::mt19937(22)};
    const Rows clip = makeRows(kRows, [&] {
        const double w = std::pow(10.0, dice(-3, 3));
        return dvec4(dice(-1, 1) * w, dice(-1, 1) * w, dice(-1, 1) * w, w);
    });
    Rows truth;
    for (const vec4 c : clip) truth.emplace_back(0.5 * dvec3(c) / double(c.w) + 0.5, 0.0);
    const Rows uvDepth = evaluate({.chunk = "shadow_coordinates.glsl",
                                   .expression = "vec4(shadowMapUvDepth(a), 0.0)",
                                   .inputs = {{"a", clip}}});
    EXPECT_ROWS_NEAR(uvDepth, truth, {.components = 3, .cause = kRounding});
}

TEST(Task2ShadowCoordinates, MapHoldsTheDepthsThatRaysFind) {
    const Rendered frame = render({.scene = "boxes@3",
                                   .size = kSmall,
                                   .settings = {"map_size=256", "fit_window=off", "fit_depth=off"},
                                   .images = {kMatrix, {"shadow_map", {256, 256}}}});
    const Image truth =
        TracedScene(loadScene("boxes@3"), kSmall)
            .depth(glm::mat4(matrixFrom(frame.at("light_clip_from_world"))), {256, 256});
    EXPECT_IMAGE_NEAR(
        frame.at("shadow_map"), truth,
        {.outliers = 0.002,
         .outlierDistance = 1e-4,
         .cause =
             "texels whose centre lies within 1/256 texel of a silhouette go either way: 0.2 %"});
}

// --- Task 3 ---

TEST(Task3DepthTest, NearerReceiversAreLitAndFartherOnesDark) {
    Dice dice{std::mt19937(31)};
    const Rows depths = makeRows(kRows, [&] { return dvec4(dice(0, 1), dice(0, 1), 0, 0); });
    Rows truth;
    for (const vec4 d : depths) truth.emplace_back(d.y <= d.x ? 1 : 0);
    const Rows litBy = evaluate({.chunk = "depth_test.glsl",
                                 .expression = "vec4(litBy(a.x, a.y))",
                                 .inputs = {{"a", depths}}});
    EXPECT_ROWS_NEAR(litBy, truth, {.cause = "a comparison has no error"});
}

TEST(Task3DepthTest, EqualDepthsAreLit) {
    Dice dice{std::mt19937(32)};
    const Rows depths = makeRows(kRows, [&] { return dvec4(dice(0, 1)); });
    const Rows litByEqualDepths = evaluate({.chunk = "depth_test.glsl",
                                            .expression = "vec4(litBy(a.x, a.x))",
                                            .inputs = {{"a", depths}}});
    EXPECT_ROWS_NEAR(litByEqualDepths, Rows(kRows, vec4(1.0f)),
                     {.cause = "the surface that the map shows is itself lit"});
}

TEST(Task3DepthTest, Filter2x2WeighsComparisonsBilinearly) {
    Dice dice{std::mt19937(33)};
    const auto random = [&] { return dvec4(dice(0, 1), dice(0, 1), dice(0, 1), dice(0, 1)); };
    const Rows stored = makeRows(kRows, random), receiver = makeRows(kRows, random),
               fraction = makeRows(kRows, random);
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const dvec2 f = dvec2(fraction[i]);
        dvec4 lit;
        for (int k = 0; k < 4; ++k) lit[k] = receiver[i][k] <= stored[i][k];
        truth.emplace_back(glm::mix(glm::mix(lit.x, lit.y, f.x), glm::mix(lit.z, lit.w, f.x), f.y));
    }
    const Rows filter2x2 = evaluate({.chunk = "depth_test.glsl",
                                     .expression = "vec4(filter2x2(a, b, c.xy))",
                                     .inputs = {{"a", stored}, {"b", receiver}, {"c", fraction}}});
    EXPECT_ROWS_NEAR(filter2x2, truth, {.cause = kRounding});
}

TEST(Task3DepthTest, NeverAveragesDepths) {
    // A vertical step: near on the left, far on the right, the receiver between. The mean of the
    // depths would switch from dark to light at once; the mean of the comparisons grows with the
    // distance.
    Rows fraction, truth;
    for (int i = 0; i < kRows; ++i) {
        fraction.emplace_back(vec4(float(i) / (kRows - 1)));
        truth.emplace_back(vec4(float(i) / (kRows - 1)));
    }
    const Rows filter2x2AcrossAStep =
        evaluate({.chunk = "depth_test.glsl",
                  .expression = "vec4(filter2x2(vec4(0.2, 0.9, 0.2, 0.9), vec4(0.5), a.xy))",
                  .inputs = {{"a", fraction}}});
    EXPECT_ROWS_NEAR(filter2x2AcrossAStep, truth, {.cause = kRounding});
}

// --- Task 4 ---

// texels, texel size, cosine
Rows biasInputs(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    return makeRows(kRows, [&] {
        return dvec4(dice(0, 8), std::pow(10.0, dice(-4, 1)), std::cos(glm::radians(dice(3, 89.9))),
                     0);
    });
}

TEST(Task4DepthBias, ConstantBiasIsCountedInTexels) {
    const Rows inputs = biasInputs(41);
    Rows truth;
    for (const vec4 i : inputs) truth.emplace_back(double(i.x) * i.y);
    const Rows constantBias = evaluate({.chunk = "depth_bias.glsl",
                                        .expression = "vec4(constantBias(a.x, a.y))",
                                        .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(constantBias, truth, {.absolute = 0, .cause = kRounding});
}

TEST(Task4DepthBias, SlopeBiasFollowsTheTangent) {
    Rows inputs = biasInputs(42);
    inputs.push_back({1.0f, 1.0f, 1e-4f, 0.0f});  // 89.99 degrees: capped
    Rows truth;
    for (const vec4 i : inputs)
        truth.emplace_back(double(i.x) * i.y *
                           std::min(std::sqrt(1.0 - double(i.z) * i.z) / i.z, 200.0));
    const Rows slopeBias = evaluate({.chunk = "depth_bias.glsl",
                                     .expression = "vec4(slopeBias(a.x, a.y, a.z))",
                                     .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(
        slopeBias, truth,
        {.absolute = 0,
         .relative = 2e-4,
         .cause =
             "1 - cos² loses four digits at 3 degrees: 5e-5, and llvmpipe's acos or atan 2e-5"});
}

TEST(Task4DepthBias, NormalOffsetFollowsTheSine) {
    const Rows inputs = biasInputs(43);
    Dice dice{std::mt19937(44)};
    const Rows facets = makeRows(kRows, [&] {
        return dvec4(glm::normalize(dvec3(dice(-1, 1), dice(-1, 1), dice(0.1, 1))), 0);
    });
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const vec4 in = inputs[i];
        truth.emplace_back(dvec4(facets[i]) * double(in.x) * double(in.y) *
                           std::sqrt(1.0 - double(in.z) * in.z));
    }
    const Rows normalOffset =
        evaluate({.chunk = "depth_bias.glsl",
                  .expression = "vec4(normalOffset(b.xyz, a.z, a.x, a.y), 0.0)",
                  .inputs = {{"a", inputs}, {"b", facets}}});
    EXPECT_ROWS_NEAR(normalOffset, truth,
                     {.absolute = 1e-6,
                      .relative = 2e-4,
                      .components = 3,
                      .cause = "1 - cos² loses four digits at 3 degrees: 5e-5"});
}

TEST(Task4DepthBias, GradientSolvesTheReceiversPlane) {
    Dice dice{std::mt19937(45)};
    Rows dx, dy, truth;
    while (truth.size() < kRows) {
        const dvec2 gradient(dice(-20, 20), dice(-20, 20)), a(dice(-1, 1), dice(-1, 1)),
            b(dice(-1, 1), dice(-1, 1));
        if (std::abs(a.x * b.y - a.y * b.x) < 0.3)
            continue;  // a well-posed system: rounding is not the question here
        dx.emplace_back(dvec4(a, glm::dot(gradient, a), 0)),
            dy.emplace_back(dvec4(b, glm::dot(gradient, b), 0));
        truth.emplace_back(dvec4(gradient, 0, 0));
    }
    dx.push_back({0.5f, 0.25f, 0.1f, 0}), dy.push_back({1.0f, 0.5f, 0.7f, 0}),
        truth.emplace_back(0.0f);  // edge-on
    const Rows receiverPlaneGradient =
        evaluate({.chunk = "depth_bias.glsl",
                  .expression = "vec4(receiverPlaneGradient(a.xyz, b.xyz), 0.0, 0.0)",
                  .inputs = {{"a", dx}, {"b", dy}}});
    EXPECT_ROWS_NEAR(receiverPlaneGradient, truth,
                     {.absolute = 1e-4,
                      .relative = 1e-5,
                      .components = 2,
                      .cause = "2 x 2 system of condition up to 7, entries rounded to 1e-6"});
}

TEST(Task4DepthBias, PlaneBiasReachesTheFarthestTexelCentre) {
    Dice dice{std::mt19937(46)};
    const Rows gradient =
        makeRows(kRows, [&] { return dvec4(dice(-20, 20), dice(-20, 20), 1.0 / 512, 1.0 / 1024); });
    const Rows radius = makeRows(kRows, [&] { return dvec4(dice(0, 4)); });
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const dvec4 g = gradient[i];
        truth.emplace_back((0.5 + radius[i].x) * (std::abs(g.x) * g.z + std::abs(g.y) * g.w));
    }
    const Rows receiverPlaneBias =
        evaluate({.chunk = "depth_bias.glsl",
                  .expression = "vec4(receiverPlaneBias(a.xy, a.zw, b.x))",
                  .inputs = {{"a", gradient}, {"b", radius}}});
    EXPECT_ROWS_NEAR(receiverPlaneBias, truth, {.cause = kRounding});
}

// A plane that nothing blocks, with the settings given. (The report prints the name of what is
// compared, so a variable's name is the student's text.)
void expectNoAcne(const std::string& scene, const std::vector<std::string>& settings,
                  const std::string& cause) {
    const Rendered frame = render({.scene = scene, .size = kSmall, .settings = settings});
    const Image& visibility = frame.at("visibility");
    EXPECT_IMAGE_NEAR(visibility, Image(kSmall.x, kSmall.y, 1, 1.0f),
                      {.outliers = 0, .outlierDistance = 0.01, .cause = scene + ", " + cause});
}

// A wall without thickness stands on the ground: the one blocker that no bias may jump over.
Scene thinWall() {
    Scene scene;
    scene.name = "thin wall";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(6.0f, 1, 0), quad({-1.5f, 0.0f, 0.0f}, {1.5f, 0.0f, 0.0f},
                                             {1.5f, 1.2f, 0.0f}, {-1.5f, 1.2f, 0.0f}, 0)};
    scene.lights = {Light::lookingAt({1.0f, 6.0f, -5.0f}, {0.0f, 0.0f, 0.0f}, 0.5f)};
    scene.camera = {.eye = {0.5f, 3.0f, 4.5f},
                    .target = {0.0f, 0.2f, 0.0f},
                    .verticalFov = 0.7f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

// Of the pixels whose light is blocked, the share that came out dark.
double darkShare(const Image& visibility, const Image& truth) {
    double blocked = 0, dark = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (truth.pixels[i] < 0.5f) blocked += 1, dark += visibility.pixels[i] < 0.5f;
    return dark / blocked;
}

TEST(Task4DepthBias, NoAcneOnAPlaneFrom10To89Degrees) {
    // A map that holds nothing shows no acne either. That is no merit.
    const Scene wall = thinWall();
    const Rendered shadow =
        render({.scene = sceneFile(wall), .size = kSmall, .settings = {"map_size=512"}});
    const Image truth = TracedScene(wall, kSmall).pointVisibility();
    EXPECT_VALUE(darkShare(shadow.at("visibility"), truth), GreaterOrEqual, 0.9,
                 "a thin wall's umbra is dark, but for the texel along its edge");
    for (const char* scene : {"tilted@10", "tilted@45", "tilted@75", "tilted@89"})
        expectNoAcne(scene, {"map_size=512"},
                     "default bias: nothing stands between this plane and the light");
    expectNoAcne("tilted@75", {"map_size=512", "filter=off", "constant_bias=0.1"},
                 "nearest texel: its plane's depth at the texel's centre, a tenth of a texel for "
                 "rounding");
    for (const char* scene : {"tilted@75", "tilted@89"})
        expectNoAcne(scene,
                     {"map_size=512", "filter=off", "receiver_plane=off", "slope_bias=0.525"},
                     "slope bias alone: half a texel is what this plane needs; the perspective "
                     "light meets it up to 2.6 % steeper");
}

TEST(Task4DepthBias, ContactShadowStartsWithinOneAndAHalfTexels) {
    const Scene scene = thinWall();
    const TracedScene truth(scene, kSmall);
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"map_size=512"},
          std::vector<std::string>{"map_size=512", "filter=off", "receiver_plane=off",
                                   "constant_bias=0.5", "slope_bias=0.5"}}) {
        const Rendered frame = render({.scene = sceneFile(scene),
                                       .size = kSmall,
                                       .settings = settings,
                                       .images = {"visibility", kMatrix}});
        const Image rays = truth.pointVisibility();
        Image umbra = interior(truth, frame.at("light_clip_from_world"), 512, 1.5f);
        for (std::size_t i = 0; i < umbra.pixels.size(); ++i)
            if (rays.pixels[i] > 0) umbra.pixels[i] = 0;
        EXPECT_IMAGE_NEAR(
            frame.at("visibility"), rays,
            {.outliers = 0,
             .outlierDistance = 0.1,
             .cause =
                 std::string(settings.size() == 1 ? "default bias"
                                                  : "half a texel of constant and slope bias") +
                 ": light farther than 1.5 texels into the wall's shadow has left its foot"},
            umbra);
    }
}

// --- Task 5 ---

Rows askOutside(const Rows& lightClip) {
    return evaluate({.chunk = "outside_map.glsl",
                     .expression = "vec4(visibilityOutsideMap(a))",
                     .inputs = {{"a", lightClip}}});
}

TEST(Task5OutsideMap, BehindTheLightIsDark) {
    Dice dice{std::mt19937(51)};
    Rows clip =
        makeRows(kRows, [&] { return dvec4(dice(-9, 9), dice(-9, 9), dice(-9, 9), dice(-9, 0)); });
    clip.push_back({1.0f, 1.0f, 1.0f, 0.0f});
    const Rows visibilityOutsideMap = askOutside(clip);
    EXPECT_ROWS_NEAR(visibilityOutsideMap, Rows(clip.size(), vec4(0.0f)),
                     {.cause = "the light shines to the side where w > 0"});
}

TEST(Task5OutsideMap, BesideTheMapAndBeforeTheNearPlaneIsLit) {
    Dice dice{std::mt19937(52)};
    Rows clip;
    for (int i = 0; i < kRows; ++i) {
        const double w = dice(0.1, 9), sign = i % 2 ? 1 : -1, beyond = sign * w * dice(1.01, 3);
        const double u = dice(-w, w), v = dice(-w, w);
        clip.emplace_back(i % 3 == 0   ? dvec4(beyond, u, v, w)
                          : i % 3 == 1 ? dvec4(u, beyond, v, w)
                                       : dvec4(u, v, -w * dice(1.01, 3), w));
    }
    const Rows visibilityOutsideMap = askOutside(clip);
    EXPECT_ROWS_NEAR(visibilityOutsideMap, Rows(clip.size(), vec4(1.0f)),
                     {.cause = "where the map knows of no blocker there is light"});
}

TEST(Task5OutsideMap, InsideAndPastTheFarPlaneTheMapIsAsked) {
    Dice dice{std::mt19937(53)};
    const Rows clip = makeRows(kRows, [&] {
        const double w = dice(0.1, 9);
        return dvec4(dice(-w, w) * 0.99, dice(-w, w) * 0.99, w * dice(-0.99, 3), w);
    });
    const Rows visibilityOutsideMap = askOutside(clip);
    EXPECT_ROWS_NEAR(visibilityOutsideMap, Rows(clip.size(), vec4(-1.0f)), {.cause = "kInsideMap"});
}

TEST(Task5OutsideMap, NoMirroredShadowBehindTheLight) {
    const Scene scene = lowLight();
    const Light& light = scene.lights[0];
    const TracedScene truth(scene, kSmall);
    const Receivers& receivers = truth.receivers();
    const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall});
    Image behind(kSmall.x, kSmall.y, 1);
    for (std::size_t i = 0; i < behind.pixels.size(); ++i)
        behind.pixels[i] = receivers.hit[i] && glm::dot(receivers.positions[i] - light.center,
                                                        light.forward()) < -0.05f;
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth.pointVisibility(),
        {.maximum = 0, .cause = "every receiver at least 0.05 behind the light's plane is dark"},
        behind);
}

// --- Task 6 ---

TEST(Task6SecondDepth, PeelsTheFirstSurfaceAndNothingElse) {
    Dice dice{std::mt19937(61)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const double first = dice(0.1, 0.9), step = i % 2 ? 1.0 / 65535 : 0.0;
        const double ahead = i % 4 < 2 ? dice(-0.5, 0.5) * step : 2 * step + dice(1e-4, 0.1);
        rows.emplace_back(dvec4(first + ahead, first, step, 0));
        truth.emplace_back(i % 4 < 2 ? 1 : 0);
    }
    const Rows isFirstSurface =
        evaluate({.chunk = "second_depth.glsl",
                  .expression = "vec4(isFirstSurface(a.x, a.y, a.z) ? 1.0 : 0.0)",
                  .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(isFirstSurface, truth,
                     {.cause = "a comparison has no error; depths differ by at most half a step, "
                               "or by at least two"});
}

TEST(Task6SecondDepth, ThresholdIsMidway) {
    Dice dice{std::mt19937(62)};
    const Rows rows = makeRows(kRows, [&] { return dvec4(dice(0, 0.5), dice(0.5, 1), 0, 0); });
    Rows truth;
    for (const vec4 r : rows) truth.emplace_back(0.5 * (double(r.x) + r.y));
    const Rows midpointDepth = evaluate({.chunk = "second_depth.glsl",
                                         .expression = "vec4(midpointDepth(a.x, a.y))",
                                         .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(midpointDepth, truth, {.cause = kRounding});
}

TEST(Task6SecondDepth, NoBiasIsNeededForClosedBlockers) {
    const TracedScene truth(loadScene("stairs@2"), kSmall);
    for (const char* format : {"depth_format=32f", "depth_format=16"}) {
        const Rendered frame =
            render({.scene = "stairs@2",
                    .size = kSmall,
                    .settings = {"second_depth=on", "receiver_plane=off", "filter=off", format},
                    .images = {"visibility", kMatrix}});
        const Image inside = interior(truth, frame.at("light_clip_from_world"), 1024, 2.0f);
        const Metrics m =
            compareVisibility(frame.at("visibility"), truth.pointVisibility(), &inside);
        EXPECT_VALUE(m.falseShadowRate, LessOrEqual, 0.001,
                     std::string(format) +
                         ": the threshold lies inside the blocker; only edges thinner than a texel "
                         "of depth remain");
        EXPECT_VALUE(m.lightLeakRate, LessOrEqual, 0.001,
                     std::string(format) + ": and nothing is lit behind it");
    }
}

// --- Task 7 ---

// Rounding, rasteriser and edges included: a hard shadow of 1024² texels against the rays of the
// same light.
void compareWithRays(const std::string& scene, double bound, double share) {
    constexpr glm::ivec2 kSize{512, 512};
    const TracedScene truth(loadScene(scene), kSize);
    const Rendered frame =
        render({.scene = scene, .size = kSize, .images = {"visibility", kMatrix}});
    const Image rays = truth.pointVisibility();
    const double rmse = compareVisibility(frame.at("visibility"), rays).rmse;
    EXPECT_VALUE(
        rmse, LessOrEqual, bound,
        scene + ": one texel along every shadow's edge, at the resolution of a window that fits");
    const Image inside = interior(truth, frame.at("light_clip_from_world"), 1024, 1.5f);
    EXPECT_IMAGE_NEAR(frame.at("visibility"), rays,
                      {.outliers = share,
                       .outlierDistance = 0.5,
                       .cause = "farther than 1.5 texels from an edge every pixel is right; "
                                "shadows thinner than half a texel slip through the mask"},
                      inside);
}

TEST(Task7WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@5", 0.035, 0); }
TEST(Task7WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@5", 0.090, 0.0001); }
TEST(Task7WholeShadow, FoliageAgreesWithRays) { compareWithRays("foliage@5", 0.145, 0.001); }
TEST(Task7WholeShadow, StairsAgreeWithRays) { compareWithRays("stairs@5", 0.058, 0); }

}  // namespace
}  // namespace penumbra
