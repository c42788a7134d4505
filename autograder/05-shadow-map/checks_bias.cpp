// Shadow maps: depth bias, formula by formula, then without acne and without peter-panning.
#include <algorithm>

#include "map_checks.h"

namespace penumbra {
namespace {

// --- Task 4 ---

// texels, texel size, cosine
Rows biasInputs(unsigned seed) {
    Dice dice{std::mt19937(seed)};
    return makeRows(kRows, [&] {
        return dvec4(dice(0, 8), std::pow(10.0, dice(-4, 1)), std::cos(glm::radians(dice(3, 89.9))),
                     0);
    });
}

TEST(Task4DepthBias, ConstantBiasIsCountedInTexels) {
    const Rows inputs = biasInputs(41);
    Rows truth;
    for (const vec4 i : inputs) truth.emplace_back(double(i.x) * i.y);
    const Rows constantBias = evaluate({.chunk = "depth_bias.glsl",
                                        .expression = "vec4(constantBias(a.x, a.y))",
                                        .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(constantBias, truth, {.absolute = 0, .cause = kRounding});
}

TEST(Task4DepthBias, SlopeBiasFollowsTheTangent) {
    Rows inputs = biasInputs(42);
    inputs.push_back({1.0f, 1.0f, 1e-4f, 0.0f});  // 89.99 degrees: capped
    Rows truth;
    for (const vec4 i : inputs)
        truth.emplace_back(double(i.x) * i.y *
                           std::min(std::sqrt(1.0 - double(i.z) * i.z) / i.z, 200.0));
    const Rows slopeBias = evaluate({.chunk = "depth_bias.glsl",
                                     .expression = "vec4(slopeBias(a.x, a.y, a.z))",
                                     .inputs = {{"a", inputs}}});
    EXPECT_ROWS_NEAR(
        slopeBias, truth,
        {.absolute = 0,
         .relative = 2e-4,
         .cause =
             "1 - cos² loses four digits at 3 degrees: 5e-5, and llvmpipe's acos or atan 2e-5"});
}

TEST(Task4DepthBias, NormalOffsetFollowsTheSine) {
    const Rows inputs = biasInputs(43);
    Dice dice{std::mt19937(44)};
    const Rows facets = makeRows(kRows, [&] {
        return dvec4(glm::normalize(dvec3(dice(-1, 1), dice(-1, 1), dice(0.1, 1))), 0);
    });
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const vec4 in = inputs[i];
        truth.emplace_back(dvec4(facets[i]) * double(in.x) * double(in.y) *
                           std::sqrt(1.0 - double(in.z) * in.z));
    }
    const Rows normalOffset =
        evaluate({.chunk = "depth_bias.glsl",
                  .expression = "vec4(normalOffset(b.xyz, a.z, a.x, a.y), 0.0)",
                  .inputs = {{"a", inputs}, {"b", facets}}});
    EXPECT_ROWS_NEAR(normalOffset, truth,
                     {.absolute = 1e-6,
                      .relative = 2e-4,
                      .components = 3,
                      .cause = "1 - cos² loses four digits at 3 degrees: 5e-5"});
}

TEST(Task4DepthBias, GradientSolvesTheReceiversPlane) {
    Dice dice{std::mt19937(45)};
    Rows dx, dy, truth;
    while (truth.size() < kRows) {
        const dvec2 gradient(dice(-20, 20), dice(-20, 20)), a(dice(-1, 1), dice(-1, 1)),
            b(dice(-1, 1), dice(-1, 1));
        if (std::abs(a.x * b.y - a.y * b.x) < 0.3)
            continue;  // a well-posed system: rounding is not the question here
        dx.emplace_back(dvec4(a, glm::dot(gradient, a), 0)),
            dy.emplace_back(dvec4(b, glm::dot(gradient, b), 0));
        truth.emplace_back(dvec4(gradient, 0, 0));
    }
    dx.push_back({0.5f, 0.25f, 0.1f, 0}), dy.push_back({1.0f, 0.5f, 0.7f, 0}),
        truth.emplace_back(0.0f);  // edge-on
    const Rows receiverPlaneGradient =
        evaluate({.chunk = "depth_bias.glsl",
                  .expression = "vec4(receiverPlaneGradient(a.xyz, b.xyz), 0.0, 0.0)",
                  .inputs = {{"a", dx}, {"b", dy}}});
    EXPECT_ROWS_NEAR(receiverPlaneGradient, truth,
                     {.absolute = 1e-4,
                      .relative = 1e-5,
                      .components = 2,
                      .cause = "2 x 2 system of condition up to 7, entries rounded to 1e-6"});
}

TEST(Task4DepthBias, PlaneBiasReachesTheFarthestTexelCentre) {
    Dice dice{std::mt19937(46)};
    const Rows gradient =
        makeRows(kRows, [&] { return dvec4(dice(-20, 20), dice(-20, 20), 1.0 / 512, 1.0 / 1024); });
    const Rows radius = makeRows(kRows, [&] { return dvec4(dice(0, 4)); });
    Rows truth;
    for (std::size_t i = 0; i < kRows; ++i) {
        const dvec4 g = gradient[i];
        truth.emplace_back((0.5 + radius[i].x) * (std::abs(g.x) * g.z + std::abs(g.y) * g.w));
    }
    const Rows receiverPlaneBias =
        evaluate({.chunk = "depth_bias.glsl",
                  .expression = "vec4(receiverPlaneBias(a.xy, a.zw, b.x))",
                  .inputs = {{"a", gradient}, {"b", radius}}});
    EXPECT_ROWS_NEAR(receiverPlaneBias, truth, {.cause = kRounding});
}

// A plane that nothing blocks, with the settings given. (The report prints the name of what is
// compared, so a variable's name is the student's text.)
void expectNoAcne(const std::string& scene, const std::vector<std::string>& settings,
                  const std::string& cause) {
    const Rendered frame = render({.scene = scene, .size = kSmall, .settings = settings});
    const Image& visibility = frame.at("visibility");
    EXPECT_IMAGE_NEAR(visibility, Image(kSmall.x, kSmall.y, 1, 1.0f),
                      {.outliers = 0, .outlierDistance = 0.01, .cause = scene + ", " + cause});
}

// Of the pixels whose light is blocked, the share that came out dark.
double darkShare(const Image& visibility, const Image& truth) {
    double blocked = 0, dark = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (truth.pixels[i] < 0.5f) blocked += 1, dark += visibility.pixels[i] < 0.5f;
    return dark / blocked;
}

TEST(Task4DepthBias, NoAcneOnAPlaneFrom10To89Degrees) {
    // A map that holds nothing shows no acne either. That is no merit.
    const Scene wall = thinWall();
    const Rendered shadow =
        render({.scene = sceneFile(wall), .size = kSmall, .settings = {"map_size=512"}});
    const Image truth = TracedScene(wall, kSmall).pointVisibility();
    EXPECT_VALUE(darkShare(shadow.at("visibility"), truth), GreaterOrEqual, 0.9,
                 "a thin wall's umbra is dark, but for the texel along its edge");
    for (const char* scene : {"tilted@10", "tilted@45", "tilted@75", "tilted@89"})
        expectNoAcne(scene, {"map_size=512"},
                     "default bias: nothing stands between this plane and the light");
    expectNoAcne("tilted@75", {"map_size=512", "filter=off", "constant_bias=0.1"},
                 "nearest texel: its plane's depth at the texel's centre, a tenth of a texel for "
                 "rounding");
    for (const char* scene : {"tilted@75", "tilted@89"})
        expectNoAcne(scene,
                     {"map_size=512", "filter=off", "receiver_plane=off", "slope_bias=0.525"},
                     "slope bias alone: half a texel is what this plane needs; the perspective "
                     "light meets it up to 2.6 % steeper");
}

TEST(Task4DepthBias, ContactShadowStartsWithinOneAndAHalfTexels) {
    const Scene scene = thinWall();
    const TracedScene truth(scene, kSmall);
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"map_size=512"},
          std::vector<std::string>{"map_size=512", "filter=off", "receiver_plane=off",
                                   "constant_bias=0.5", "slope_bias=0.5"}}) {
        const Rendered frame = render({.scene = sceneFile(scene),
                                       .size = kSmall,
                                       .settings = settings,
                                       .images = {"visibility", kMatrix}});
        const Image rays = truth.pointVisibility();
        Image umbra = interior(truth, frame.at("light_clip_from_world"), 512, 1.5f);
        for (std::size_t i = 0; i < umbra.pixels.size(); ++i)
            if (rays.pixels[i] > 0) umbra.pixels[i] = 0;
        EXPECT_IMAGE_NEAR(
            frame.at("visibility"), rays,
            {.outliers = 0,
             .outlierDistance = 0.1,
             .cause =
                 std::string(settings.size() == 1 ? "default bias"
                                                  : "half a texel of constant and slope bias") +
                 ": light farther than 1.5 texels into the wall's shadow has left its foot"},
            umbra);
    }
}

}  // namespace
}  // namespace penumbra
