// The signed shadow: how deep a ray goes counts, too.
#include <algorithm>
#include <cmath>

#include "field_checks.h"

namespace penumbra {
namespace {

TEST(Task5Signed, ARayAlongTheSurfaceSeesHalfTheLight) {
    Dice dice(51);
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const double edge = i % 4 ? dice(0.01, 0.3) : dice(1, 4);
        const double tangent = i % 8 == 0 ? 0 : edge * dice(-1.3, 1.3);
        const double ratio = std::sin(std::atan(tangent));
        rows.emplace_back(dvec4(ratio, edge, 0, 0));
        truth.emplace_back(std::clamp(0.5 + 0.5 * tangent / edge, 0.0, 1.0));
    }
    const Rows signedVisibility = evaluate({.chunk = "signed.glsl",
                                            .expression = "vec4(signedVisibility(a.x, a.y))",
                                            .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(signedVisibility, truth,
                     {.absolute = 5e-4, .cause = "arcsin on a software rasteriser: 2e-4"});
}

TEST(Task5Signed, ASlabsPenumbraIsALinearRamp) {
    EXPECT_VALUE(errorUnderSlab({.thickness = 1}, {"method=signed", "grid=64"}), LessOrEqual, 0.025,
                 "TBD");
}

// Through a thin slab a ray is never deep: half the slab's thickness over t, no more, whatever lies
// behind. That much light leaks, by formula; a hard shadow, which asks for the sign alone, has
// none.
TEST(Task5Signed, AThinSlabLeaksByItsThickness) {
    const SlabStage stage{.thickness = 0.4};
    const Scene scene = stage.scene();
    const std::string file = sceneFile(scene);
    const GroundPixels pixels(scene, kSmall);
    const Image exact = pixels.image([&](dvec3 p) { return stage.visibility(p); });
    const Rendered soft =
        render({.scene = file, .size = kSmall, .settings = {"method=signed", "grid=64"}});
    const Rendered hard =
        render({.scene = file, .size = kSmall, .settings = {"method=hard", "grid=64"}});
    double leak = 0, expected = 0, lit = 0, count = 0;
    const dvec3 light(0, SlabStage::kLightHeight, 0);
    for (std::size_t i = 0; i < pixels.mask.pixels.size(); ++i) {
        if (pixels.mask.pixels[i] == 0 || exact.pixels[i] > 0) continue;
        const dvec3 p = pixels.positions[i];
        const double reach = glm::length(light - p);
        const double ratio = closest(stage.shape(), p, (light - p) / reach, 0.01, reach).ratio;
        const double edge = 0.5 * SlabStage::kLightWidth / reach;
        expected += std::max(0.5 + 0.5 * std::tan(std::asin(ratio)) / edge, 0.0);
        leak += soft.at("visibility").pixels[i];
        lit += hard.at("visibility").pixels[i];
        count += 1;
    }
    EXPECT_VALUE(count, Greater, 1000, "receivers from which the slab hides all of the light");
    EXPECT_VALUE(
        std::abs(leak - expected) / count, LessOrEqual, 0.1,
        "half-way between two voxels the middle of the slab is missed by up to half a voxel, "
        "0.07, at t = 3.8: so much of the light's 0.094");
    EXPECT_VALUE(lit, Equal, 0, "the slab is 2.7 voxels thick: some look-up in it is negative");
}

TEST(Task5Signed, BoxesAndFenceAgreeWithRays) {
    EXPECT_VALUE(errorAgainstRays("boxes@7", {"method=signed"}), LessOrEqual, 0.027,
                 "one number for all that the light's square sees");
    EXPECT_VALUE(errorAgainstRays("fence@3", {"method=signed"}), LessOrEqual, 0.092,
                 "boards thinner than a few voxels leak, and there is more than one edge");
}

}  // namespace
}  // namespace penumbra
