// Planar shadows: whole pictures against rays.
#include <fmt/format.h>

#include "planar_checks.h"

namespace penumbra {
namespace {

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
