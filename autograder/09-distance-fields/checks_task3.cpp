// The lecture's shadow: what is near to the ray, over t, against where the light's edge is seen.
#include <algorithm>
#include <cmath>

#include "field_checks.h"

namespace penumbra {
namespace {

TEST(Task3Lecture, TheLightsEdgeIsHalfAWidthAside) {
    Dice dice(31);
    Rows lights, truth;
    for (int i = 0; i < kRows; ++i) {
        const double width = dice(0.001, 6), distance = dice(0.5, 20);
        lights.emplace_back(dvec4(width, distance, 0, 0));
        truth.emplace_back(0.5 * width / distance);
    }
    const Rows lightEdgeRatio = evaluate({.chunk = "lecture.glsl",
                                          .expression = "vec4(lightEdgeRatio(a.x, a.y))",
                                          .inputs = {{"a", lights}}});
    EXPECT_ROWS_NEAR(lightEdgeRatio, truth, {.cause = "one product and one quotient in float32"});
}

TEST(Task3Lecture, VisibilityRisesFromTheRayToTheLightsEdge) {
    Dice dice(32);
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        const double edge = i % 4 ? dice(0.001, 0.3) : dice(1, 4), k = dice(0.25, 8);
        const double ratio = i % 8 == 0 ? 0 : edge / k * dice(-0.5, 1.5);
        rows.emplace_back(dvec4(ratio, edge, k, 0));
        truth.emplace_back(std::clamp(k * ratio / edge, 0.0, 1.0));
    }
    const Rows lectureVisibility = evaluate({.chunk = "lecture.glsl",
                                             .expression = "vec4(lectureVisibility(a.x, a.y, a.z))",
                                             .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(lectureVisibility, truth, {.cause = "three factors in float32"});
}

TEST(Task3Lecture, TheSafeAnglesTangentStaysFinite) {
    Dice dice(33);
    Rows ratios, truth;
    for (int i = 0; i < kRows; ++i) {
        const double ratio = i < 4   ? dvec4(-1, 1, -3, 3)[i]
                             : i % 2 ? dice(-0.99, 0.99)
                                     : dice(-1.2, 1.2);
        ratios.emplace_back(ratio);
        truth.emplace_back(std::tan(std::asin(std::clamp(double(float(ratio)), -0.9999, 0.9999))));
    }
    const Rows safeTangent = evaluate({.chunk = "lecture.glsl",
                                       .expression = "vec4(safeTangent(a.x))",
                                       .inputs = {{"a", ratios}}});
    // 1 - 0.9999² = 2e-4, a difference of numbers rounded to 6e-8: 3e-4 of it, half of that below
    // the root; arcsin and tangent of a software rasteriser are a little worse than that.
    EXPECT_ROWS_NEAR(safeTangent, truth,
                     {.absolute = 5e-4,
                      .relative = 1e-3,
                      .cause = "at 0.9999 the cosine squared, 2e-4, is a difference of numbers "
                               "rounded to 6e-8; arcsin on a software rasteriser: 2e-4"});
}

// What the lecture's form makes of the slab, from its box's exact distance. A ray that meets it is
// dark at once; else the least distance / t decides.
Image lectureTruth(const SlabStage& stage, const GroundPixels& pixels, double offset, double k) {
    const dvec3 light(0, SlabStage::kLightHeight, 0);
    return pixels.image([&](dvec3 position) {
        const dvec3 origin = position + dvec3(0, offset, 0);
        const double reach = glm::length(light - origin);
        const dvec3 direction = (light - origin) / reach;
        const double ratio = leastRatio(
            [&](double t) { return stage.shape().distance(origin + t * direction); }, 0.01, reach);
        return std::clamp(k * ratio * 2 * reach / SlabStage::kLightWidth, 0.0, 1.0);
    });
}

TEST(Task3Lecture, ASlabsShadowFollowsTheFormula) {
    const SlabStage stage;
    const Scene scene = stage.scene();
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = kSmall,
                                   .settings = {"method=lecture", "grid=64", "step_cap=0.1"},
                                   .images = {"visibility", {"field", {2, 1}}}});
    const double cell = frame.at("field").at(0, 0, 3);
    const GroundPixels pixels(scene, kSmall);
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), lectureTruth(stage, pixels, 0.25 * cell, 1.5),
        {.mean = 0.004,
         .cause = "a voxel away from the edge, interpolation is off by an eighth of a "
                  "voxel, 0.019, which k makes 0.08 at t = 4; farther away it is less, "
                  "and a twentieth of the pixels are so near"},
        pixels.mask);
}

TEST(Task3Lecture, BoxesAreAsFarFromRaysAsTheFormIs) {
    EXPECT_VALUE(errorAgainstRays("boxes@7", {"method=lecture"}), LessOrEqual, 0.050,
                 "only the lit half of a penumbra is seen, and steeper than it is");
}

}  // namespace
}  // namespace penumbra
