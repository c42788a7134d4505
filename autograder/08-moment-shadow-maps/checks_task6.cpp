// Task 6: the whole shadow beside rays, on other seeds than the gallery's.
#include "core/metrics.h"
#include "core/truths.h"
#include "moment_checks.h"

namespace penumbra {
namespace {

constexpr glm::ivec2 kSize{256, 256};

Metrics besideRays(const std::string& name, const std::vector<std::string>& settings = {}) {
    const Rendered frame = render({.scene = name, .size = kSize, .settings = settings});
    return compareVisibility(frame.at("visibility"),
                             TracedScene(loadScene(name), kSize).areaVisibility(256));
}

struct Bars {
    double rmse, leak;
};

void compareWithRays(const std::string& name, Bars bars,
                     const std::vector<std::string>& settings = {}) {
    const Metrics m = besideRays(name, settings);
    EXPECT_VALUE(m.rmse, LessOrEqual, bars.rmse,
                 name +
                     ": one blocker depth stands for all, four moments for all depths: what that "
                     "costs here, and at least a quarter more");
    EXPECT_VALUE(m.lightLeakRate, LessOrEqual, bars.leak,
                 name + ": the share of the umbra's pixels that got more than a tenth of light");
}

TEST(Task6WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@7", {0.013, 0.03}); }
TEST(Task6WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@3", {0.045, 0.04}); }
TEST(Task6WholeShadow, FoliageAgreesWithRays) { compareWithRays("foliage@4", {0.15, 0.3}); }
TEST(Task6WholeShadow, StairsAgreeWithRays) { compareWithRays("stairs@5", {0.025, 0.03}); }

TEST(Task6WholeShadow, SixteenBitsAreEnough) {
    compareWithRays("boxes@7", {0.013, 0.03}, {"storage=quantized16"});
    // A texel alone, so that nothing evens out what is rounded.
    const Rendered wall =
        render({.scene = "tilted@10",
                .size = kSize,
                .settings = {"storage=quantized16", "filter=fixed", "filter_radius=0.5"}});
    const Image lit(kSize.x, kSize.y, 1, 1.0f);
    EXPECT_IMAGE_NEAR(wall.at("visibility"), lit,
                      {.maximum = 0.06,
                       .cause = "a lone plane, moments rounded to 1.6e-5: a bias of twice that "
                                "leaves a false share of 5 % (README §2)"});
}

TEST(Task6WholeShadow, HausdorffIsCloserToRays) {
    const double hamburger = besideRays("stairs@5").rmse;
    const double hausdorff = besideRays("stairs@5", {"method=hausdorff"}).rmse;
    EXPECT_VALUE(hausdorff, Less, hamburger, "stairs@5: the better bound, rmse below Hamburger's");
    EXPECT_VALUE(hausdorff, LessOrEqual, 0.025, "stairs@5: and within Hamburger's bar");
}

}  // namespace
}  // namespace penumbra
