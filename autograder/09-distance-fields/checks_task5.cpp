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

// rmse against the exact share of the light, over receivers on the ground.
double slabError(const SlabStage& stage, const SettingList& settings) {
    const Scene scene = stage.scene();
    const Rendered frame = render({.scene = sceneFile(scene), .size = kSmall, .settings = settings});
    const GroundPixels pixels(scene, kSmall);
    const Image truth = pixels.image([&](dvec3 p) { return stage.visibility(p); });
    return rmse(frame.at("visibility"), truth, pixels.mask);
}

TEST(Task5Signed, ASlabsPenumbraIsALinearRamp) {
    EXPECT_VALUE(slabError({.thickness = 1}, {"method=signed", "grid=64"}), LessOrEqual, 0.02, "TBD");
}

}  // namespace
}  // namespace penumbra
