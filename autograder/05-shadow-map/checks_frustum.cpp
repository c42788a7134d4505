// Shadow maps: the light's view and its coordinates, by closed form and by rays.
#include <algorithm>

#include "map_checks.h"

namespace penumbra {
namespace {

// --- Task 1 ---

// The light's view as its matrix tells it: tangents and distances (README §1).
struct Frustum {
    double left, right, bottom, top, nearPlane, farPlane;
};

Frustum frustumOf(const glm::dmat4& lightClipFromWorld, const Light& light) {
    const glm::dmat4 p = lightClipFromWorld * glm::inverse(glm::dmat4(light.viewFromWorld()));
    return {(p[2][0] - 1) / p[0][0], (p[2][0] + 1) / p[0][0], (p[2][1] - 1) / p[1][1],
            (p[2][1] + 1) / p[1][1], p[3][2] / (p[2][2] - 1), p[3][2] / (p[2][2] + 1)};
}

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

}  // namespace
}  // namespace penumbra
