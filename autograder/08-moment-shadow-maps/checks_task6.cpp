// Task 6: the whole shadow beside rays, on other seeds than the gallery's.
#include <map>

#include "core/metrics.h"
#include "moment_checks.h"
#include "truth/visibility.h"

namespace penumbra {
namespace {

constexpr glm::ivec2 kSize{256, 256};

const Image& rays(const std::string& name) {
    static std::map<std::string, Image> traced;
    Image& truth = traced[name];
    if (truth.empty()) {
        const Scene scene = loadScene(name);
        const RayTracer tracer(scene);
        truth = areaVisibility(tracer, tracer.receivers(scene.camera, kSize), scene.lights[0], 256);
    }
    return truth;
}

Metrics besideRays(const std::string& name, const std::vector<std::string>& settings = {}) {
    const Rendered frame = render({.scene = name, .size = kSize, .settings = settings});
    return compareVisibility(frame.at("visibility"), rays(name));
}

struct Bars {
    double rmse, leak;
};

void compareWithRays(const std::string& name, Bars bars,
                     const std::vector<std::string>& settings = {}) {
    const Metrics m = besideRays(name, settings);
    EXPECT_VALUE(m.rmse, LessOrEqual, bars.rmse,
                 name +
                     ": one blocker depth stands for all, four moments for all depths; 1.5 times "
                     "what that costs here");
    EXPECT_VALUE(m.lightLeakRate, LessOrEqual, bars.leak,
                 name + ": the share of the umbra's pixels that got more than a tenth of light");
}

TEST(Task6WholeShadow, BoxesAgreeWithRays) { compareWithRays("boxes@7", {0.013, 0.03}); }
TEST(Task6WholeShadow, FenceAgreesWithRays) { compareWithRays("fence@3", {0.045, 0.04}); }
TEST(Task6WholeShadow, FoliageAgreesWithRays) { compareWithRays("foliage@4", {0.15, 0.3}); }
TEST(Task6WholeShadow, StairsAgreeWithRays) { compareWithRays("stairs@5", {0.025, 0.03}); }

TEST(Task6WholeShadow, SixteenBitsAgreeWithRaysAsWell) {
    compareWithRays("boxes@7", {0.013, 0.03}, {"storage=quantized16"});
}

TEST(Task6WholeShadow, HausdorffIsCloserToRays) {
    const double hamburger = besideRays("stairs@5").rmse;
    const double hausdorff = besideRays("stairs@5", {"method=hausdorff"}).rmse;
    EXPECT_VALUE(hausdorff, Less, hamburger, "stairs@5: the better bound, rmse below Hamburger's");
}

}  // namespace
}  // namespace penumbra
