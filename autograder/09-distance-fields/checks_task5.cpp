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
                 "voxels of 0.15: the edge is off by up to half of one, 0.07 / 3.8 of the light's "
                 "0.19: a tenth at worst, a quarter of that in the mean square");
}

// The slab far from its edges, as voxels tell it: exact at their centres, linear in between.
double slabBetweenVoxels(const SlabStage& stage, double lower, double cell, double y) {
    const double row = (y - lower) / cell - 0.5, below = std::floor(row);
    const auto at = [&](double voxel) {
        const double middle = SlabStage::kTop - 0.5 * stage.thickness;
        return std::abs(lower + (voxel + 0.5) * cell - middle) - 0.5 * stage.thickness;
    };
    return std::lerp(at(below), at(below + 1), row - below);
}

// Through a thin slab a ray is never deep: half the slab's thickness over t, no more, whatever lies
// behind. That much light leaks, by formula; a hard shadow, which asks for the sign alone, has
// none.
TEST(Task5Signed, AThinSlabLeaksByItsThickness) {
    const SlabStage stage{.thickness = 0.4};
    const Scene scene = stage.scene();
    const std::string file = sceneFile(scene);
    const GroundPixels pixels(scene, kSmall);
    const Rendered soft = render({.scene = file,
                                  .size = kSmall,
                                  .settings = {"method=signed", "grid=64", "step_cap=0.1",
                                               "smallest_step=0.1", "max_steps=512"},
                                  .images = {"visibility", {"field", {2, 1}}}});
    const Rendered hard =
        render({.scene = file, .size = kSmall, .settings = {"method=hard", "grid=64"}});
    const double lower = soft.at("field").at(0, 0, 1), cell = soft.at("field").at(0, 0, 3);
    const dvec3 light(0, SlabStage::kLightHeight, 0);
    Image mask = pixels.mask;
    double lit = 0, count = 0;
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        mask.pixels[i] *= pixels.positions[i].x < -1.2;
        lit += mask.pixels[i] * hard.at("visibility").pixels[i];
        count += mask.pixels[i];
    }
    const Image leak = pixels.image([&](dvec3 p) {
        const double reach = glm::length(light - p);
        const double ratio = leastRatio(
            [&](double t) {
                return slabBetweenVoxels(stage, lower, cell, p.y + t * (light.y - p.y) / reach);
            },
            0.01, reach);
        const double edge = 0.5 * SlabStage::kLightWidth / reach;
        return std::clamp(0.5 + 0.5 * std::tan(std::asin(ratio)) / edge, 0.0, 1.0);
    });
    EXPECT_VALUE(count, Greater, 1000, "receivers from which the slab hides all of the light");
    EXPECT_IMAGE_NEAR(
        soft.at("visibility"), leak,
        {.maximum = 0.01,
         .cause = "in the slab steps are a tenth of the distance, 0.02: its middle is "
                  "missed by 0.01 at most, where t is 3.8: two hundredths of the light's "
                  "0.17, half of that on either side"},
        mask);
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
