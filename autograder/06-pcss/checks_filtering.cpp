// Soft shadows: twins of the filter and of the search on the program's own map, then both together.
#include <algorithm>

#include "core/metrics.h"
#include "soft_checks.h"

namespace penumbra {
namespace {

// --- Tasks 3 and 4: twins on the program's own map, without the receiver's plane ---

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

// Two samples along a side miss much: whoever filters where the search has answered is seen.
TEST(Task5Pcss, FiltersAsTheSearchSays) {
    constexpr int kSearch = 2, kFilter = 6;
    const std::string scene = "foliage@3";
    const Rendered frame = render({.scene = scene,
                                   .size = kSmall,
                                   .settings = {"receiver_plane=off", "pyramid=off", "kernel=grid",
                                                "search_samples=2", "filter_samples=6"},
                                   .images = {"visibility",
                                              "penumbra_width",
                                              "search",
                                              "receiver",
                                              "light_height",
                                              {"shadow_map", {512, 512}},
                                              kMatrix}});
    const MapView view(frame.at("light_clip_from_world"), loadScene(scene).lights[0]);
    const Map map{frame.at("shadow_map")};
    const Image &receivers = frame.at("receiver"), &heights = frame.at("light_height");
    Image truth(kSmall.x, kSmall.y, 1), mask(kSmall.x, kSmall.y, 1);
    for (int y = 0; y < kSmall.y; ++y)
        for (int x = 0; x < kSmall.x; ++x) {
            if (receivers.at(x, y, 3) <= 0) continue;
            mask.at(x, y) = 1;
            const vec3 height(heights.at(x, y, 0), heights.at(x, y, 1), heights.at(x, y, 2));
            const bool wholeLight = height.x > 0.5f * (std::abs(height.y) + std::abs(height.z));
            const float blocked = std::round(kSearch * kSearch * frame.at("search").at(x, y, 2));
            if (blocked == kSearch * kSearch || (blocked == 0 && wholeLight)) {
                truth.at(x, y) = blocked == 0;
                continue;
            }
            const vec2 uv(receivers.at(x, y, 0), receivers.at(x, y, 1));
            const float depth = receivers.at(x, y, 2);
            const double bias = view.bias(depth, 512);
            const vec2 width = glm::max(vec2(view.scaleUv) * frame.at("penumbra_width").at(x, y),
                                        vec2(1.0f / 512));
            int lit = 0;
            visitGrid(uv, width, kFilter, [&](vec2 sample) {
                const vec2 light = (sample - uv) / width;
                const float over = height.x + height.y * light.x + height.z * light.y;
                lit += over > 0 && !(depth - map(sample) > bias);
            });
            truth.at(x, y) = float(lit) / (kFilter * kFilter);
        }
    EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                      {.outliers = 0.002,
                       .outlierDistance = 0.01,
                       .cause = "your own search and width, the same samples of the same map; of "
                                "36 samples one lies within rounding, 3e-5 texels, of a border "
                                "in 0.2 % of the pixels"},
                      mask);
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

// A wall hides all of the light that stands over the ground; the rest is below the horizon.
void expectNothingFromBelowTheHorizon() {
    Scene scene = settingLight();
    scene.name = "setting light behind a wall";
    scene.meshes.push_back(box({-8.0f, 0.0f, -2.6f}, {8.0f, 4.0f, -2.5f}, 0));
    const Receivers receivers = TracedScene(scene, kSmall).receivers();
    Image mask(kSmall.x, kSmall.y, 1);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i)
        mask.pixels[i] = receivers.hit[i] && receivers.positions[i].y < 1e-3f &&
                         receivers.positions[i].z > -2.4f;
    const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), Image(kSmall.x, kSmall.y, 1),
                      {.outliers = 0,
                       .outlierDistance = 0.25,
                       .cause = "ground before a wall that hides all of the light above the "
                                "horizon: a third of the light, below it, must not shine; a "
                                "filter somewhat too wide is another check's matter"},
                      mask);
}

TEST(Task5Pcss, TheHorizonIsCountedOnce) {
    expectHorizonOnly(loadScene("tilted@85"), {});
    expectHorizonOnly(settingLight(), {});
    expectNothingFromBelowTheHorizon();
}

}  // namespace
}  // namespace penumbra
