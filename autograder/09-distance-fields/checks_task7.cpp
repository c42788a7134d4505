// The whole shadow: against rays on scenes that the gallery does not show, and where it must not
// change.
#include <algorithm>
#include <cmath>

#include "core/metrics.h"
#include "field_checks.h"

namespace penumbra {
namespace {

const std::string kQuarters =
    "each quarter of the light sees one straight edge, and voxels round it off";

TEST(Task7WholeShadow, BoxesAgreeWithRays) {
    EXPECT_VALUE(errorAgainstRays("boxes@7"), LessOrEqual, 0.012, kQuarters);
}
TEST(Task7WholeShadow, FenceAgreesWithRays) {
    EXPECT_VALUE(errorAgainstRays("fence@3"), LessOrEqual, 0.085, kQuarters);
}
TEST(Task7WholeShadow, StairsAgreeWithRays) {
    EXPECT_VALUE(errorAgainstRays("stairs@5"), LessOrEqual, 0.04, kQuarters);
}

TEST(Task7WholeShadow, WithoutABlockerAllIsLit) {
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
    const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), Image(kSmall.x, kSmall.y, 1, 1.0f),
                      {.maximum = 0, .cause = "nothing blocks"});
}

double meanOf(const Image& image) {
    double sum = 0;
    for (const float value : image.pixels) sum += value;
    return sum / double(image.pixels.size());
}

TEST(Task7WholeShadow, ScalingTheWorldChangesNothing) {
    const Scene scene = SlabStage{.turnRadians = 0.5}.scene();
    const SettingList settings{"grid=64"};
    const auto visibility = [&](float scale) {
        return render(
            {.scene = sceneFile(scaled(scene, scale)), .size = kSmall, .settings = settings});
    };
    const Rendered one = visibility(1);
    EXPECT_VALUE(meanOf(one.at("visibility")), Less, 0.8, "there is a shadow that could change");
    const char* cause = "a power of two changes no digit of a float";
    EXPECT_IMAGE_NEAR(visibility(16).at("visibility"), one.at("visibility"),
                      {.maximum = 1e-6, .cause = cause});
    EXPECT_IMAGE_NEAR(visibility(0.0625f).at("visibility"), one.at("visibility"),
                      {.maximum = 1e-6, .cause = cause});
}

TEST(Task7WholeShadow, ATinyLightCastsAHardShadowAndAHugeOneStaysFinite) {
    constexpr glm::ivec2 kSize{256, 256};
    const Image hard = TracedScene(loadScene("boxes@7"), kSize).pointVisibility();
    const Rendered tiny =
        render({.scene = "boxes@7", .size = kSize, .settings = {"light_size=0.001"}});
    EXPECT_VALUE(compareVisibility(tiny.at("visibility"), hard).rmse, LessOrEqual, 0.04,
                 "a voxel along every edge, as for a hard shadow map of so many texels");
    const Rendered huge = render({.scene = "boxes@7", .size = kSize, .settings = {"light_size=4"}});
    const Image& visibility = huge.at("visibility");
    const auto [low, high] =
        std::minmax_element(visibility.pixels.begin(), visibility.pixels.end());
    EXPECT_VALUE(*low, GreaterOrEqual, 0, "a share");
    EXPECT_VALUE(*high, LessOrEqual, 1, "a share");
}

}  // namespace
}  // namespace penumbra
