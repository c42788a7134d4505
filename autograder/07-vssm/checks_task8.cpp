// The whole shadow beside rays.
#include "core/metrics.h"
#include "core/truths.h"
#include "variance_checks.h"

namespace penumbra {
namespace {

void compareWithRays(const std::string& name, double bound, double leak) {
    const Image truth = TracedScene(loadScene(name), kSmall).areaVisibility(144);
    const Rendered frame = render({.scene = name, .size = kSmall});
    const Metrics m = compareVisibility(frame.at("visibility"), truth);
    EXPECT_VALUE(m.rmse, LessOrEqual, bound,
                 name + ": a bound stands for the share, one blocker depth for all");
    if (leak < 1)
        EXPECT_VALUE(
            m.lightLeakRate, LessOrEqual, leak,
            name + ": the share of the umbra's pixels that got more than a tenth of light");
}

TEST(Task8WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@7", 0.019, 0.03); }
TEST(Task8WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@3", 0.055, 1); }
TEST(Task8WholeShadow, FoliageAgreesWithRays) { compareWithRays("foliage@4", 0.23, 1); }
TEST(Task8WholeShadow, StairsAgreeWithRays) { compareWithRays("stairs@5", 0.04, 1); }

}  // namespace
}  // namespace penumbra
