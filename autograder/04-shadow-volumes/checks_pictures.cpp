// Shadow volumes: several lights in closed form, and whole shadows against rays.
#include <glad/gl.h>

#include <fmt/format.h>
#include <algorithm>

#include "volume_checks.h"

namespace penumbra {
namespace {

// A colour is a half float, and blending rounds it once for every light: 2^-11 of up to 2 each.
constexpr double kHalfFloats = 4.0 / 2048;
const std::string kRounding = "colours are half floats, rounded with every light: 4 x 2^-11";

// Boxes on a ground, all of one material, and three lights, each with a shadow of its own.
Scene yard(std::vector<Light> lights) {
    Scene scene;
    scene.name = "yard";
    scene.materials = {{.name = "grey", .baseColor = vec3(0.5f)}};
    scene.meshes = {ground(9.0f, 2, 0), box({-1.2f, 0.01f, -0.5f}, {-0.2f, 1.4f, 0.6f}, 0),
                    box({0.6f, 0.9f, -1.0f}, {1.6f, 1.3f, 0.2f}, 0),
                    box({0.2f, 0.01f, 1.1f}, {0.5f, 0.9f, 1.9f}, 0)};
    scene.lights = std::move(lights);
    scene.camera = {.eye = {0.5f, 5.0f, 6.0f}, .target = {0, 0.3f, 0}, .verticalFov = 0.8f};
    return scene;
}

Light colored(Light light, vec3 color) {
    light.color = color;
    return light;
}

std::vector<Light> threeLights() {
    return {colored(lampAt({-3, 5, 2}), {1, 0, 0}), colored(sunFrom({3, 5, -1}), {0, 1, 0}),
            colored(lampAt({0.7f, 4, -3}), {0, 0, 1})};
}

Image pictureOf(const Scene& scene, const SettingList& settings = {}, const char* image = "color") {
    return render({.scene = sceneFile(scene),
                   .size = {kSize, kSize},
                   .settings = settings,
                   .images = {image}})
        .at(image);
}

Image onSurfaces(const Receivers& receivers) {
    Image mask(receivers.width, receivers.height, 1);
    for (std::size_t i = 0; i < receivers.hit.size(); ++i) mask.pixels[i] = receivers.hit[i];
    return mask;
}

Image interiorSurfaces(const RayPicture& rays) {
    Image mask = onSurfaces(rays.receivers);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] *= rays.interior.pixels[i];
    return mask;
}

// --- Task 7 ---

TEST(Task7SeveralLights, ALightIsAddedWhereItsCountIsZero) {
    const Rendered frame =
        render({.scene = "boxes", .size = {16, 16}, .images = {{"light_pass_state", {7, 1}}}});
    std::vector<int> mine;
    for (int i = 0; i < 7; ++i) mine.push_back(int(frame.at("light_pass_state").at(i, 0)));
    const bool seen = mine[1] == GL_EQUAL || mine[1] == GL_LEQUAL;  // nothing lies before it
    EXPECT_VALUE(seen, Equal, 1, "depthTest lets the surface pass that is seen");
    expectEqualLists(
        "addLight(), without depthTest", {mine[0], mine[2], mine[3], mine[4], mine[5], mine[6]},
        {1, 0, GL_EQUAL, 0, GL_ONE, GL_ONE}, "clear, keep depth, count equal to 0, one plus one");
}

TEST(Task7SeveralLights, PicturesOfSingleLightsAddUp) {
    const std::vector<Light> lights = threeLights();
    const Image all = pictureOf(yard(lights));
    const Image turned = pictureOf(yard({lights[2], lights[0], lights[1]}));
    const Receivers receivers = TracedScene(yard(lights), {kSize, kSize}).receivers();
    Image sum(kSize, kSize, 3, -2 * 0.22f * 0.5f);  // ambient light, once instead of three times
    for (const Light& light : lights) {
        const Image one = pictureOf(yard({light}));
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += one.pixels[i];
    }
    // Rasterised alike: surfaces' edges count, too, but a ray may see the background there.
    const ImageTolerance tolerance{.outliers = 1e-3,
                                   .outlierDistance = kHalfFloats,
                                   .cause = kRounding +
                                            "; pixels that ray and rasteriser see "
                                            "differently at the ground's edge"};
    EXPECT_IMAGE_NEAR(all, sum, tolerance, onSurfaces(receivers));
    EXPECT_IMAGE_NEAR(all, turned, {.maximum = kHalfFloats, .cause = kRounding});
    double brightest = 0;
    for (const float v : all.pixels) brightest = std::max(brightest, double(v));
    EXPECT_VALUE(brightest, Greater, 0.3, "ambient light alone is 0.11");
}

void expectColors(const Scene& scene, const SettingList& settings = {}) {
    const Stage stage = staged(scene);
    const RayPicture rays(stage.scene, {kSize, kSize});
    EXPECT_IMAGE_NEAR(pictureOf(stage.scene, settings), colorTruth(stage.scene, rays),
                      {.maximum = kHalfFloats, .cause = kRounding}, interiorSurfaces(rays));
}

TEST(Task7SeveralLights, EveryLightHasItsOwnShadow) {
    expectColors(yard(threeLights()));
    std::vector<Light> turned = threeLights();
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    expectColors(yard(turned), {"method=zpass"});
}

TEST(Task7SeveralLights, WhatASurfaceEmitsKnowsNoShadow) {
    Scene scene = yard({lampAt({0, 6, 0}), lampAt({0.5f, 6, 0.5f})});
    scene.materials[0].emissive = {0.3f, 0.05f, 0.15f};
    scene.meshes.push_back(box({-5, 5.5f, -5}, {5, 5.6f, 5}, 0));  // hides both lights
    const Stage stage = staged(scene);
    const RayPicture rays(stage.scene, {kSize, kSize});
    EXPECT_IMAGE_NEAR(pictureOf(stage.scene), colorTruth(stage.scene, rays),
                      {.maximum = kHalfFloats, .cause = kRounding}, interiorSurfaces(rays));
}

TEST(Task7SeveralLights, LightEndsAtItsRangeAndItsPlane) {
    Light nearby = lampAt({-1.5f, 2.2f, 1.0f});
    nearby.range = 3.0f;
    const Light sideways = Light::lookingAt({0.5f, 1.8f, -1.2f}, {2, 1.5f, 3}, 0.5f);
    for (const Light& light : {nearby, sideways, sunFrom({-1, 0.3f, 0.4f})}) {
        const Stage stage = staged(yard({light}));
        const RayPicture rays(stage.scene, {kSize, kSize});
        const Rendered frame = render(
            {.scene = stage.file, .size = {kSize, kSize}, .images = {"visibility", "color"}});
        EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility[0],
                          {.maximum = 0, .cause = "farther than a pixel from every edge"},
                          interiorSurfaces(rays));
        EXPECT_IMAGE_NEAR(frame.at("color"), colorTruth(stage.scene, rays),
                          {.maximum = kHalfFloats, .cause = kRounding}, interiorSurfaces(rays));
    }
}

// --- Task 8 ---

void expectRays(const char* name, int mayDiffer, const SettingList& settings = {}) {
    constexpr glm::ivec2 kLarge{512, 512};
    const Scene scene = loadScene(name);
    const RayPicture rays(scene, kLarge);
    const Rendered frame =
        render({.scene = name, .size = kLarge, .settings = settings, .images = {"visibility"}});
    const Image& mine = frame.at("visibility");
    std::vector<glm::ivec2> inside;
    int different = 0;
    for (int y = 0; y < kLarge.y; ++y)
        for (int x = 0; x < kLarge.x; ++x) {
            if (mine.at(x, y) == rays.visibility[0].at(x, y)) continue;
            ++different;
            if (rays.interior.at(x, y) > 0) inside.emplace_back(x, y);
        }
    if (inside.size() <= 100)  // else the picture is all wrong
        std::erase_if(inside, [&](glm::ivec2 pixel) {
            const std::size_t i = std::size_t(pixel.y) * kLarge.x + std::size_t(pixel.x);
            return edgeAround(scene, kLarge, pixel, rays.receivers.positions[i]);
        });
    EXPECT_VALUE(
        different, LessOrEqual, mayDiffer,
        fmt::format("pixels of {} that rays see otherwise: edges snap to 1/256 pixel", name));
    EXPECT_VALUE(inside.size(), Equal, 0,
                 "of them farther than a pixel from every edge of a shadow or of a surface");
}

TEST(Task8WholeShadow, BoxesAgreeWithRays) { expectRays("boxes@5", 30); }
TEST(Task8WholeShadow, FenceAgreesWithRays) { expectRays("fence@5", 25); }
TEST(Task8WholeShadow, StairsAgreeWithRays) { expectRays("stairs@5", 30); }
TEST(Task8WholeShadow, FoliageAgreesWithRaysWithBothMethods) {
    for (const char* method : {"method=zpass", "method=zfail"})
        expectRays("foliage@5", 110, {method});
}
TEST(Task8WholeShadow, OpenMeshesAgreeWithRays) { expectRays("open_mesh@5", 60); }

TEST(Task8WholeShadow, BothMethodsCountAlike) {
    for (const char* scene : {"foliage", "stairs@3", "sun@2"}) {
        const auto counts = [&](const char* method) {
            return render({.scene = scene,
                           .size = {kCountSize, kCountSize},
                           .settings = {method},
                           .images = {"stencil_count"}})
                .at("stencil_count");
        };
        const Receivers receivers =
            TracedScene(loadScene(scene), {kCountSize, kCountSize}).receivers();
        const Image before = counts("method=zpass");
        EXPECT_IMAGE_NEAR(before, counts("method=zfail"),
                          {.maximum = 0,
                           .cause = "a closed volume's crossings sum to 0: what lies before a "
                                    "surface is what does not lie behind it"},
                          onSurfaces(receivers));
        EXPECT_VALUE(shareOfZeros(before), Less, 0.99, "volumes were drawn");
    }
}

TEST(Task8WholeShadow, AFloatCountsBeyond255) { expectCounts("nested@300", {"counter=float"}); }

TEST(Task8WholeShadow, CullingLeavesNoTrace) {
    const SettingList none{"cull_range=off", "cull_view=off", "cull_empty=off", "scissor=off",
                           "cache=off"};
    for (const char* time : {"time=0", "time=9.5"}) {
        const auto frame = [&](SettingList settings) {
            settings.emplace_back(time);
            return render({.scene = "courtyard",
                           .size = {kCountSize, kCountSize},
                           .settings = settings,
                           .images = {"visibility", "color"}});
        };
        const Rendered culled = frame({}), whole = frame(none);
        const std::string cause = "culling leaves out what changes no pixel: not one bit differs";
        EXPECT_IMAGE_NEAR(culled.at("visibility"), whole.at("visibility"),
                          {.maximum = 0, .cause = cause});
        EXPECT_IMAGE_NEAR(culled.at("color"), whole.at("color"), {.maximum = 0, .cause = cause});
        const double dark = shareOfZeros(culled.at("visibility"));
        EXPECT_VALUE(dark, Greater, 0.05, "the key light throws shadows");
        EXPECT_VALUE(dark, Less, 0.95, "and does not leave all in the dark");
    }
}

TEST(Task8WholeShadow, LanternsOfTheCourtyardAgreeWithRays) {
    const Scene courtyard = loadScene("courtyard@2");
    for (const std::size_t lantern : {std::size_t(0), std::size_t(3), std::size_t(9)}) {
        Scene scene = courtyard;
        scene.lights = {courtyard.lights[lantern]};
        const RayPicture rays(scene, {kSize, kSize});
        EXPECT_IMAGE_NEAR(pictureOf(scene, {}, "visibility"), rays.visibility[0],
                          {.maximum = 0, .cause = "farther than a pixel from every edge"},
                          rays.interior);
    }
}

TEST(Task8WholeShadow, HugeAndTinyScenesCastTheSameShadow) {
    const Scene scene = loadScene("stairs@4");
    const Image usual = pictureOf(scene, {}, "visibility");
    for (const int exponent : {-20, 20})
        EXPECT_IMAGE_NEAR(
            pictureOf(scaled(scene, std::ldexp(1.0f, exponent)), {}, "visibility"), usual,
            {.maximum = 0, .cause = "powers of two round nothing: not one bit differs"});
    const RayPicture rays(scene, {kSize, kSize});
    EXPECT_IMAGE_NEAR(usual, rays.visibility[0],
                      {.maximum = 0, .cause = "farther than a pixel from every edge"},
                      rays.interior);
}

}  // namespace
}  // namespace penumbra
