// Too little bias and too much of it: what each texel more buys, and what it costs.
#include <fmt/format.h>

#include <algorithm>

#include "core/curves.h"
#include "map_checks.h"

namespace penumbra {
namespace {

constexpr int kMap = 256;

// A plane tilted by the angle under a light so far that its rays are parallel to half a per cent,
// in a square window: the drawing of the handout.
Scene tiltedUnderParallelLight(double degrees) {
    const float rise = float(std::tan(glm::radians(degrees)));
    Scene scene;
    scene.name = "tilted plane, parallel light";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {quad({-1.0f, -rise, 1.0f}, {1.0f, -rise, 1.0f}, {1.0f, rise, -1.0f},
                         {-1.0f, rise, -1.0f}, 0)};
    scene.lights = {Light::lookingAt({0.0f, 200.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 0.2f)};
    scene.camera = {.eye = {0.0f, 60.0f, 0.0f},
                    .target = {0.0f, 0.0f, 0.0f},
                    .up = {0.0f, 0.0f, -1.0f},
                    .verticalFov = 0.03f,
                    .nearPlane = 1.0f,
                    .farPlane = 100.0f};
    return scene;
}

std::vector<std::string> constantBias(double texels) {
    return {fmt::format("map_size={}", kMap), "filter=off", "receiver_plane=off",
            fmt::format("constant_bias={}", texels)};
}

// Not one pixel to a texel: every place within a texel gets its share.
constexpr glm::ivec2 kPixels{397, 397};

// Per cent of a plane that nothing blocks.
double acne(const Scene& plane, double texels) {
    const Rendered frame =
        render({.scene = sceneFile(plane), .size = kPixels, .settings = constantBias(texels)});
    const auto& pixels = frame.at("visibility").pixels;
    const auto dark = std::count_if(pixels.begin(), pixels.end(), [](float v) { return v < 0.5f; });
    return 100.0 * double(dark) / double(pixels.size());
}

// In tangents, the longer side: given code counts its texels so.
double texelTangent(const Image& lightClipFromWorld) {
    const glm::dmat4 m = matrixFrom(lightClipFromWorld);
    const auto row = [&](int i) { return dvec3(m[0][i], m[1][i], m[2][i]); };
    const dvec3 axis = row(3);  // of unit length: w is a distance
    const auto perUnit = [&](int i) { return glm::length(row(i) - glm::dot(row(i), axis) * axis); };
    return 2.0 / (kMap * std::min(perUnit(0), perUnit(1)));
}

struct Gap {
    double measured, formula;  // texels
};

// How far light reaches into the wall's shadow at its foot, mean over the columns of the picture's
// middle, clear of the wall's ends. A receiver g behind the foot is |P - L| g / (g + 5) behind the
// wall along its ray (the light stands 5 before the wall), which a bias as long jumps over.
Gap gapAtTheFoot(double texels) {
    constexpr glm::ivec2 kSize{512, 512};  // two pixels to a texel
    const Scene wall = thinWall();
    const Rendered frame = render({.scene = sceneFile(wall),
                                   .size = kSize,
                                   .settings = constantBias(texels),
                                   .images = {"visibility", kMatrix}});
    const Image& visibility = frame.at("visibility");
    const TracedScene truth(wall, kSize);
    const Receivers& receivers = truth.receivers();
    double sum = 0, columns = 0;
    for (int x = 3 * kSize.x / 8; x < 5 * kSize.x / 8; ++x, ++columns) {
        const auto z = [&](int y) {
            return double(receivers.positions[std::size_t(y * kSize.x + x)].z);
        };
        int y = 0;  // the first pixel of the ground before the wall
        while (z(y) < 1e-4) ++y;
        const int foot = y;
        while (visibility.at(x, y) > 0.5f && y + 1 < kSize.y) ++y;
        if (y > foot) sum += (z(y - 1) + z(y)) / 2;  // between the last lit and the first dark
    }
    const dvec3 light = wall.lights.at(0).center;
    const glm::dmat4 clipFromWorld = matrixFrom(frame.at("light_clip_from_world"));
    const double w = (clipFromWorld * dvec4(0, 0, 0, 1)).w;
    const double texel = texelTangent(frame.at("light_clip_from_world")) * w;
    const double distance = glm::length(light), bias = texels * texel;
    return {sum / columns / texel, -light.z * bias / (distance - bias) / texel};
}

CURVE(bias) {
    PlotPanel acneOfPlanes{{"acne [% of a lit plane]"}, {}};
    PlotSeries gap{.name = "measured"}, gapFormula{.name = "formula", .formula = true};
    Curve curve{.title = "Constant bias: acne against peter-panning",
                .says =
                    "Acne falls on a straight line and is gone at ½ tan θ; from there on a texel "
                    "of bias buys nothing and widens the gap at the foot of a wall.",
                .x = {"constant bias [texels]"}};
    double worst = 0;
    for (const double degrees : {45.0, 75.0}) {
        const Scene plane = tiltedUnderParallelLight(degrees);
        const double needed = 0.5 * std::tan(glm::radians(degrees));
        PlotSeries measured{.name = fmt::format("{:g}°", degrees)}, formula{"", {}, true};
        for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0}) {
            measured.points.emplace_back(share * needed, acne(plane, share * needed));
            formula.points.emplace_back(share * needed, 50 * (1 - share));
            worst = std::max(worst, std::abs(measured.points.back().y - formula.points.back().y));
        }
        const double acneAtTheMark = measured.points.back().y,
                     acneJustBelow = measured.points[measured.points.size() - 2].y;
        EXPECT_VALUE(acneAtTheMark, Equal, 0, "a texel's edge is half a texel from its centre");
        EXPECT_VALUE(acneJustBelow, Greater, 0, "5 % too little: the texels' edges stay dark");
        measured.points.emplace_back(6, acne(plane, 6));
        formula.points.emplace_back(6, 0);
        acneOfPlanes.series.insert(acneOfPlanes.series.end(), {measured, formula});
        curve.marks.push_back({needed, fmt::format("½ tan {:g}°", degrees)});
    }
    EXPECT_VALUE(worst, LessOrEqual, 2.5,
                 "397 rows of pixels, each at one place within its texel: counting, a standard "
                 "deviation of 2.5 %");
    worst = 0;
    for (double texels = 0; texels <= 6; texels += 0.5) {
        const Gap g = gapAtTheFoot(texels);
        gap.points.emplace_back(texels, g.measured);
        gapFormula.points.emplace_back(texels, g.formula);
        worst = std::max(worst, std::abs(g.measured - g.formula));
    }
    EXPECT_VALUE(worst, LessOrEqual, 0.25, "pixels half a texel high end it");
    curve.panels = {acneOfPlanes, {{"gap at a wall's foot [texels]"}, {gap, gapFormula}}};
    return curve;
}

}  // namespace
}  // namespace penumbra
