// Soft shadows: whole pictures against rays, and backprojection.
#include "core/metrics.h"
#include "soft_checks.h"

namespace penumbra {
namespace {

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
