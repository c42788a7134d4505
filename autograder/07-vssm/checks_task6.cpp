// Soft shadows: the search by a twin on plates whose depths are known, and what must hold in any
// scene.
#include <optional>

#include "core/metrics.h"
#include "core/truths.h"
#include "truth/closed_form.h"
#include "variance_checks.h"

namespace penumbra {
namespace {

constexpr glm::ivec2 kFrame{128, 128};
constexpr int kMap = 512;
constexpr double kLeastWidth = 4.0 / kMap, kMinVariance = 1e-6;
constexpr double kBiasTexels = 8;  // so many that no window may be narrower by it
// A float32 corner of a map of 512 is good to 3e-5 texels; a depth that is good to 1e-4 moves an
// edge of the next window, up to 150 texels wide, by 1e-2.
constexpr double kRoundingTexels = 0.02;
constexpr double kRoundingShare = 1e-4;  // of a cell, by a mean that is good to 1e-5

// --- The search, on plates: every surface but the ground has one depth ---

struct Blockers {
    double share = 0, depth = 0;
};

class PlatesSearch {
public:
    PlatesSearch(int queries, int cells, float groundSlope = 0.0f)
        : queries_(queries),
          cells_(cells),
          frame_(render({.scene = sceneFile(platesScene(groundSlope)),
                         .size = kFrame,
                         .settings = {"light_bleeding=0.3",  // no matter of the search's
                                      "constant_bias=8", "least_width=4", "min_variance=1e-6",
                                      "queries=" + std::to_string(queries),
                                      "search_cells=" + std::to_string(cells)},
                         .images = {"blocker_depth",
                                    "penumbra_width",
                                    "receiver",
                                    "light_height",
                                    {"shadow_map", {kMap, kMap}},
                                    kMatrix}})),
          boxes_(frame_.at("shadow_map")),
          light_(frame_.at("light_clip_from_world"), platesScene(groundSlope).lights[0]) {}

    void expectTwin() const;

private:
    struct Receiver {
        dvec2 uv;
        double depth;
        dvec2 slope;  // of its plane: depth per uv
    };

    // README §6, in float64. No answer where a float32 may round an edge of the window to another
    // texel than this does, or a share to the other side of the guard of README §5.
    std::optional<Blockers> inWindow(const Receiver& receiver, dvec2 width) const {
        const dvec2 low = (receiver.uv - 0.5 * width) * double(kMap),
                    high = low + width * double(kMap);
        const dvec2 cells = (high - glm::floor(low)) / double(cells_);
        const dvec2 nearest = glm::min(glm::abs(low - glm::round(low)),
                                       glm::abs(cells - glm::round(cells)) * double(cells_));
        if (std::min(nearest.x, nearest.y) < kRoundingTexels) return {};
        const dvec2 corner = glm::floor(low) / double(kMap), cell = glm::ceil(cells) / double(kMap);
        Blockers found;
        for (int j = 0; j < cells_; ++j)
            for (int i = 0; i < cells_; ++i) {
                dvec2 box = boxes_.meanVariance(corner + (dvec2(i, j) + 0.5) * cell, cell);
                box.y = std::max(box.y, kMinVariance);
                const dvec2 offset = ((dvec2(i, j) + 0.5) / double(cells_) - 0.5) * width;
                const double depth = receiver.depth +
                                     std::min(glm::dot(receiver.slope, offset), 0.0) -
                                     light_.bias(receiver.depth, kBiasTexels, kMap);
                const double lit = upperBound(depth, box), blocked = 1 - lit;
                if (std::abs(blocked - 0.001) < kRoundingShare) return {};
                found.share += blocked;
                found.depth += blocked < 0.001
                                   ? blocked * depth
                                   : std::clamp(box.x - lit * depth, 0.0, blocked * depth);
            }
        if (found.share > 0) found.depth /= found.share;
        found.share /= cells_ * cells_;
        return found;
    }

    // A twin where every window holds enough blockers that its float32 table tells their depth.
    std::optional<Blockers> search(const Receiver& receiver) const {
        dvec2 window = receiver.depth * light_.scaleUv;
        std::optional<Blockers> found;
        for (int query = 0; query < queries_; ++query) {
            found = inWindow(receiver, glm::max(window, kLeastWidth));
            if (!found || found->share < 0.02) return {};
            window = glm::min(window, 1.5 * (receiver.depth - found->depth) * light_.scaleUv);
        }
        return found;
    }

    int queries_, cells_;
    Rendered frame_;
    DepthBoxes boxes_;
    LightView light_;
};

void PlatesSearch::expectTwin() const {
    const Image &receivers = frame_.at("receiver"), &heights = frame_.at("light_height");
    Image depth(kFrame.x, kFrame.y, 1), width = depth, mask = depth;
    double compared = 0;
    for (int y = 0; y < kFrame.y; ++y)
        for (int x = 0; x < kFrame.x; ++x) {
            if (receivers.at(x, y, 3) <= 0) continue;
            const dvec2 rise(heights.at(x, y, 1), heights.at(x, y, 2));
            const Receiver receiver{.uv = {receivers.at(x, y, 0), receivers.at(x, y, 1)},
                                    .depth = receivers.at(x, y, 2),
                                    .slope = rise / (light_.scaleUv * double(heights.at(x, y, 0)))};
            const auto found = search(receiver);
            if (!found) continue;
            depth.at(x, y) = float(found->depth);
            width.at(x, y) = float(receiver.depth - found->depth);
            mask.at(x, y) = 1, ++compared;
        }
    EXPECT_VALUE(compared, Greater, 1000, "receivers of this scene that have blockers");
    const std::string cause =
        "the same boxes of the same map in float64; depths of a float32 table are good to 1e-5, "
        "and a share of blockers of 2 % magnifies that by 50, a single cell's by more";
    EXPECT_IMAGE_NEAR(frame_.at("blocker_depth"), depth, {.maximum = 1e-3, .cause = cause}, mask);
    EXPECT_IMAGE_NEAR(frame_.at("penumbra_width"), width, {.maximum = 1e-3, .cause = cause}, mask);
}

TEST(Task6SoftShadows, TheFirstWindowHoldsAllThatCanBlock) { PlatesSearch(1, 1).expectTwin(); }

TEST(Task6SoftShadows, CellsCountByTheirShareOfBlockers) { PlatesSearch(1, 3).expectTwin(); }

TEST(Task6SoftShadows, EachCellIsComparedOnTheReceiversPlane) {
    PlatesSearch(1, 3, -0.5f).expectTwin();
}

TEST(Task6SoftShadows, TheNextWindowIsAsWideAsWhatWasFound) { PlatesSearch(2, 1).expectTwin(); }

// --- The filter, on the same plates ---

// The normal distribution's answer is another than the bound's, and neither has a table of its own.
TEST(Task6SoftShadows, TheFilterAsksTheChosenEstimate) {
    constexpr double kVariance = 1e-3;
    const Rendered frame = render(
        {.scene = sceneFile(platesScene()),
         .size = kFrame,
         .settings = {"estimate=normal", "prefilter=sat_cpu_integer", "constant_bias=8",
                      "least_width=4", "min_variance=1e-3"},
         .images = {
             "visibility", "blocker_depth", "receiver", {"shadow_map", {kMap, kMap}}, kMatrix}});
    const DepthBoxes boxes(frame.at("shadow_map"));
    const LightView light(frame.at("light_clip_from_world"), platesScene().lights[0]);
    const Image &receivers = frame.at("receiver"), &blockers = frame.at("blocker_depth");
    Image truth(kFrame.x, kFrame.y, 1, 1.0f), mask(kFrame.x, kFrame.y, 1);
    double compared = 0;
    for (int y = 0; y < kFrame.y; ++y)
        for (int x = 0; x < kFrame.x; ++x) {
            if (receivers.at(x, y, 3) <= 0 || blockers.at(x, y) <= 0) continue;
            const double depth = receivers.at(x, y, 2),
                         threshold = depth - light.bias(depth, kBiasTexels, kMap);
            const dvec2 uv(receivers.at(x, y, 0), receivers.at(x, y, 1));
            const dvec2 width = glm::max((depth - blockers.at(x, y)) * light.scaleUv, kLeastWidth);
            truth.at(x, y) = float(overCells(uv, width, 2, [&](dvec2 center, dvec2 cell) {
                const dvec2 box = boxes.meanVariance(center, cell);
                return 0.5 *
                       std::erfc((threshold - box.x) / std::sqrt(2 * std::max(box.y, kVariance)));
            }));
            mask.at(x, y) = 1, ++compared;
        }
    EXPECT_VALUE(compared, Greater, 1000, "receivers of this scene that have blockers");
    EXPECT_IMAGE_NEAR(
        frame.at("visibility"), truth,
        {.maximum = 1e-3,
         .cause = "the same boxes in float64; edges of a box are good to 3e-5 of its 2 "
                  "texels or more, and what they move is a depth of up to 1 over a "
                  "deviation of 0.03 at least"},
        mask);
}

// --- Any scene ---

TEST(Task6SoftShadows, AHalfPlanesPenumbraIsALinearRamp) {
    const Receivers receivers = TracedScene(loadScene("halfplane"), kSmall).receivers();
    const Rendered frame = render({.scene = "halfplane",
                                   .size = kSmall,
                                   .settings = {"constant_bias=0", "least_width=4",
                                                "min_variance=1e-6", "light_bleeding=0"}});
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < receivers.positions.size(); ++i) {
        const vec3 p = receivers.positions[i];
        if (!receivers.hit[i] || p.y > 0.01f) continue;
        const double error = frame.at("visibility").pixels[i] -
                             halfPlaneVisibility(p.x, kHalfPlaneBlockerHeight,
                                                 kHalfPlaneLightHeight, kHalfPlaneLightWidth);
        sum += error * error, count += 1;
    }
    EXPECT_VALUE(std::sqrt(sum / count), LessOrEqual, 0.004,
                 "two depths, for which the bound is exact: what is left is the map's texel");
}

// A plane that nothing blocks: what it sees of the light is what is above its horizon.
void expectHorizonOnly(const Scene& scene) {
    const Receivers receivers = TracedScene(scene, kFrame).receivers();
    Image truth(kFrame.x, kFrame.y, 1, 1.0f);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        if (receivers.hit[i])
            truth.pixels[i] = float(horizonVisibility(receivers.positions[i],
                                                      receivers.facetNormals[i], scene.lights[0]));
    const Rendered frame = render({.scene = sceneFile(scene), .size = kFrame});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                      {.maximum = 1e-4,
                       .cause = scene.name + ": nothing blocks, and the horizon is a closed form; "
                                             "heights over a plane keep 1e-5 of their distance"});
}

Scene bareGround(float size, Light light) {
    Scene scene;
    scene.name = "bare ground";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(size, 1, 0)};
    scene.lights = {light};
    scene.camera = {.eye = {0.0f, 4.0f, 6.0f},
                    .target = {0.0f, -0.3f, 0.0f},
                    .verticalFov = 0.85f,
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

TEST(Task6SoftShadows, WhereNothingBlocksTheHorizonAloneCounts) {
    expectHorizonOnly(loadScene("tilted@60"));
    expectHorizonOnly(loadScene("tilted@89"));
    // A wide light, half of it below the ground that it shines along.
    expectHorizonOnly(
        bareGround(6, Light::lookingAt({1.0f, 0.5f, -6.0f}, {0.0f, -0.5f, 0.0f}, 3.0f)));
    const Light above = Light::lookingAt({1.0f, 7.0f, 0.5f}, vec3(0.0f), 1.0f);
    const Rendered frame = render({.scene = sceneFile(bareGround(4, above)),
                                   .size = kFrame,
                                   .images = {"visibility", "blocker_depth"}});
    EXPECT_IMAGE_NEAR(frame.at("visibility"), Image(kFrame.x, kFrame.y, 1, 1.0f),
                      {.maximum = 0, .cause = "bare ground under the whole light: no blocker"});
    EXPECT_IMAGE_NEAR(frame.at("blocker_depth"), Image(kFrame.x, kFrame.y, 1),
                      {.maximum = 0, .cause = "bare ground under the whole light: no blocker"});
}

TEST(Task6SoftShadows, ScalingTheWorldChangesNothing) {
    const Scene scene = loadScene("stairs@5");
    const Rendered one = render({.scene = sceneFile(scene), .size = kFrame});
    const Rendered sixteen = render({.scene = sceneFile(scaled(scene, 16.0f)), .size = kFrame});
    const auto& pixels = one.at("visibility").pixels;
    EXPECT_VALUE(*std::min_element(pixels.begin(), pixels.end()), Less, 0.05,
                 "there must be a shadow to compare");
    EXPECT_IMAGE_NEAR(sixteen.at("visibility"), one.at("visibility"),
                      {.maximum = 1e-6, .cause = "a power of two changes no digit of a float"});
}

TEST(Task6SoftShadows, ATinyLightCastsAHardShadowAndAHugeOneStaysFinite) {
    const Image hard = TracedScene(loadScene("boxes@7"), kFrame).pointVisibility();
    const Rendered tiny =
        render({.scene = "boxes@7", .size = kFrame, .settings = {"light_size=0.001"}});
    EXPECT_VALUE(compareVisibility(tiny.at("visibility"), hard).rmse, LessOrEqual, 0.05,
                 "four texels of a map of 512 along every edge, the narrowest filter");
    const Rendered huge =
        render({.scene = "boxes@7", .size = kFrame, .settings = {"light_size=4"}});
    const Image& visibility = huge.at("visibility");
    const auto [low, high] =
        std::minmax_element(visibility.pixels.begin(), visibility.pixels.end());
    EXPECT_VALUE(*low, GreaterOrEqual, 0, "a share");
    EXPECT_VALUE(*high, LessOrEqual, 1, "a share");
}

}  // namespace
}  // namespace penumbra
