// The whole shadow, against rays, and where it must not change.
#include <algorithm>
#include <cmath>

#include "core/metrics.h"
#include "field_checks.h"
#include "truth/visibility.h"

namespace penumbra {
namespace {

void compareWithRays(const std::string& name, double bound) {
    constexpr glm::ivec2 kSize{256, 256};
    const Scene scene = loadScene(name);
    const RayTracer tracer(scene);
    const Image truth =
        areaVisibility(tracer, tracer.receivers(scene.camera, kSize), scene.lights[0], 144);
    const Rendered frame = render({.scene = name, .size = kSize});
    const Metrics m = compareVisibility(frame.at("visibility"), truth);
    EXPECT_VALUE(m.rmse, LessOrEqual, bound, name + ": TBD");
}

TEST(Task7WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@7", 0.027); }
TEST(Task7WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@3", 0.092); }
TEST(Task7WholeShadow, FoliageAgreesWithRays) { compareWithRays("foliage@4", 0.2); }
TEST(Task7WholeShadow, StairsAgreeWithRays) { compareWithRays("stairs@5", 0.1); }

}  // namespace
}  // namespace penumbra
