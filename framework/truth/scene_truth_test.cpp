#include "truth/scene_truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/metrics.h"
#include "scene/gallery.h"
#include "truth/visibility.h"

namespace penumbra {
namespace {

TEST(ExactVisibility, IsWhatRaysTendTo) {
    for (const char* name : {"halfplane", "halfplane@3", "polygon", "polygon@7", "tilted@60"}) {
        const Scene scene = loadScene(name);
        const RayTracer tracer(scene);
        const Receivers receivers = tracer.receivers(scene.camera, {96, 96});
        const auto exact = exactVisibility(scene, receivers);
        ASSERT_TRUE(exact) << name;
        const Image rays = areaVisibility(tracer, receivers, scene.lights[0], 1024);
        // standardError() is an upper bound of the strata's noise.
        EXPECT_LE(compareVisibility(rays, *exact).rmse, standardError(*exact, 1024) + 1e-6) << name;
        // At 1024 strata the noise of one pixel is at most that of independent rays, 1/64; 6 σ.
        EXPECT_LE(compareVisibility(rays, *exact).maximum, 6.0 / 64) << name;
    }
}

TEST(ExactVisibility, IsNoneWhereNoFormulaIs) {
    const Scene scene = loadScene("boxes");
    const RayTracer tracer(scene);
    EXPECT_FALSE(exactVisibility(scene, tracer.receivers(scene.camera, {8, 8})));
}

}  // namespace
}  // namespace penumbra
