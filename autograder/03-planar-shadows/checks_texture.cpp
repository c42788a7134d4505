// Planar shadows: the shadow as a texture, for receivers of any form.
#include "planar_checks.h"

namespace penumbra {
namespace {

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

}  // namespace
}  // namespace penumbra
