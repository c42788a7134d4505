// Shadow maps: whole pictures against rays.
#include "core/metrics.h"
#include "map_checks.h"

namespace penumbra {
namespace {

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
