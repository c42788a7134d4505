// Exponential warps: limits, moments, bounds, against float64.
#include <limits>

#include "variance_checks.h"

namespace penumbra {
namespace {

const std::string kExp = "exp() of a software rasteriser: 4e-6, and its argument's rounding";

TEST(Task7Exponential, TheExponentKeepsFloatsFinite) {
    Dice dice{std::mt19937(71)};
    Rows rows, unchanged;
    for (int i = 0; i < kRows; ++i) {
        const bool squared = i % 2 == 0;
        rows.emplace_back(dvec4(dice(0.1, squared ? 42 : 88), squared ? 1 : 0, 0, 0));
        unchanged.emplace_back(rows.back().x);
    }
    for (const float exponent : {50.0f, 100.0f, 1000.0f})
        for (const float squared : {0.0f, 1.0f}) rows.emplace_back(exponent, squared, 0, 0);
    const Rows limited = evaluate({.chunk = "exponential.glsl",
                                   .expression = "vec4(limitedExponent(a.x, a.y > 0.5))",
                                   .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(Rows(limited.begin(), limited.begin() + kRows), unchanged,
                     {.absolute = 0, .relative = 0, .cause = "below the limit nothing changes"});
    const double last = std::log(double(std::numeric_limits<float>::max()));  // 88.72
    for (std::size_t i = kRows; i < rows.size(); ++i) {
        const double powers = rows[i].y > 0.5f ? 2 : 1;
        EXPECT_VALUE(limited[i].x, Less, last / powers, "the largest float is exp(88.72)");
        EXPECT_VALUE(limited[i].x, GreaterOrEqual,
                     std::min(double(rows[i].x), powers > 1 ? 42.0 : 88.0),
                     "and as large as README §7 says, no smaller");
    }
}

TEST(Task7Exponential, BothWarpsAndTheirSquares) {
    Dice dice{std::mt19937(72)};
    Rows rows, relative, ones(kRows, vec4(1.0f));
    std::vector<dvec4> truth;
    for (int i = 0; i < kRows; ++i) {
        const float depth = i % 8 == 0 ? 0.0f : i % 8 == 1 ? 1.0f : float(dice(0, 1));
        const float exponent = i % 8 == 2 ? 42.0f : float(dice(0.1, 42));
        const double up = std::exp(double(exponent) * double(depth));
        rows.emplace_back(depth, exponent, 0, 0);
        truth.emplace_back(up, up * up, -1 / up, 1 / (up * up));
    }
    const Rows warped = evaluate({.chunk = "exponential.glsl",
                                  .expression = "warpedMoments(a.x, a.y)",
                                  .inputs = {{"a", rows}}});
    // e^84 and e^-84 in one row: each by its own size.
    for (std::size_t i = 0; i < warped.size(); ++i)
        relative.emplace_back(dvec4(warped[i]) / truth[i]);
    EXPECT_ROWS_NEAR(relative, ones,
                     {.absolute = 2e-5, .relative = 0, .components = 4, .cause = kExp});
}

// A share `lit` of a box at `far`, the rest at `near`; and a receiver.
struct WarpedBox {
    double near = 0, far = 0, lit = 0, depth = 0, exponent = 0;
    double mean(double scale) const {  // of exp(scale d)
        return (1 - lit) * std::exp(scale * near) + lit * std::exp(scale * far);
    }
};

TEST(Task7Exponential, TheExponentialShareIsClampedToOne) {
    Dice dice{std::mt19937(73)};
    Rows rows, truth;
    for (int i = 0; i < kRows; ++i) {
        WarpedBox box{.near = dice(0, 0.9), .lit = dice(0, 1), .exponent = dice(1, 80)};
        box.far = dice(box.near, 1);
        box.depth = i % 4 == 0 ? dice(0, box.near) : i % 4 == 1 ? box.far : dice(0, 1);
        const vec4 row(dvec4(box.mean(box.exponent), box.depth, box.exponent, 0));
        const double share = double(row.x) * std::exp(-double(row.z) * double(row.y));
        rows.push_back(row);
        truth.emplace_back(std::min(share, 1.0));
    }
    rows.emplace_back(std::exp(88.0f), 1.0f, 88.0f, 0), truth.emplace_back(1.0f);
    rows.emplace_back(1.0f, 1.0f, 88.0f, 0), truth.emplace_back(0.0f);
    rows.emplace_back(std::exp(88.0f), 0.0f, 88.0f, 0), truth.emplace_back(1.0f);
    const Rows esmLit = evaluate({.chunk = "exponential.glsl",
                                  .expression = "vec4(esmLit(a.x, a.y, a.z))",
                                  .inputs = {{"a", rows}}});
    EXPECT_ROWS_NEAR(esmLit, truth, {.absolute = 3e-5, .relative = 3e-5, .cause = kExp});
}

// The bound of one warp: depths d become sign · exp(sign · c · d), which grows with d.
double warpedBound(const dvec2& moments, const WarpedBox& box, double sign, double minVariance) {
    const double depth = sign * std::exp(sign * box.exponent * box.depth);
    const double slope = box.exponent * depth;
    const double variance =
        std::max(moments.y - moments.x * moments.x, minVariance * slope * slope);
    return upperBound(depth, {moments.x, variance});
}

TEST(Task7Exponential, TheLesserOfTwoBounds) {
    Dice dice{std::mt19937(74)};
    Rows moments, receivers, truth;
    int positive = 0, negative = 0;
    while (int(truth.size()) < kRows) {
        WarpedBox box{.lit = dice(0.1, 0.9), .exponent = dice(2, 10)};
        box.near = dice(0, 0.7), box.far = box.near + dice(0.2, 0.3);
        box.depth = truth.size() % 4 == 0 ? box.far : dice(0, 1);
        const double c = box.exponent, minVariance = truth.size() % 2 == 0 ? 0 : dice(0.001, 0.05);
        const vec4 row(dvec4(box.mean(c), box.mean(2 * c), -box.mean(-c), box.mean(-2 * c)));
        const dvec4 m(row);
        const double above = warpedBound({m.x, m.y}, box, 1, minVariance);
        const double below = warpedBound({m.z, m.w}, box, -1, minVariance);
        moments.push_back(row);
        receivers.emplace_back(dvec4(box.depth, c, minVariance, 0));
        truth.emplace_back(std::min(above, below));
        positive += above < below - 0.01, negative += below < above - 0.01;
    }
    EXPECT_VALUE(std::min(positive, negative), Greater, kRows / 16, "rows decided by either side");
    const Rows evsmLit = evaluate({.chunk = "exponential.glsl",
                                   .expression = "vec4(evsmLit(a, b.x, b.y, b.z))",
                                   .inputs = {{"a", moments}, {"b", receivers}}});
    EXPECT_ROWS_NEAR(evsmLit, truth,
                     {.absolute = 2e-4,
                      .relative = 0,
                      .cause = "a variance of at least 0.01 of the mean square, from float32 "
                               "moments and exp(): 4e-6 / 0.01, halved"});
}

TEST(Task7Exponential, EveryTexelIsWarpedFinitely) {
    constexpr int kMap = 128;
    const Rendered frame =
        render({.scene = "stairs@3",
                .size = kTiny,
                .settings = {"map_size=128", "estimate=evsm", "exponent=100"},
                .images = {{"warped", {kMap, kMap}}, {"shadow_map", {kMap, kMap}}}});
    const Image &warped = frame.at("warped"), &map = frame.at("shadow_map");
    Image exponents(kMap, kMap, 2), truth(kMap, kMap, 2);
    double largest = 0;
    for (const float d : map.pixels) largest = std::max(largest, double(d));
    const double up = *std::max_element(warped.pixels.begin(), warped.pixels.end());
    const double exponent = 0.5 * std::log(std::max(up, 1.0)) / largest;
    EXPECT_VALUE(exponent, GreaterOrEqual, 41.9, "README §7: 42 where squares are kept");
    for (int y = 0; y < kMap; ++y)
        for (int x = 0; x < kMap; ++x) {
            const double d = map.at(x, y);
            for (int c = 0; c < 2; ++c) {
                truth.at(x, y, c) = float(c == 0 ? d : -d);
                exponents.at(x, y, c) = float(
                    std::log(std::max(std::abs(double(warped.at(x, y, 2 * c))), 1e-30)) / exponent);
            }
        }
    EXPECT_IMAGE_NEAR(exponents, truth, {.maximum = 1e-5, .cause = kExp + ", as logarithms"});
}

// --- Whole frames ---

// Means of a warp of the map's depths, as given/mip_levels.glsl takes them, in float64.
class MipBoxes {
public:
    template <typename Warp>
    MipBoxes(const Image& map, Warp warp) {
        levels_.emplace_back();
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x)
                levels_[0].push_back(warp(double(map.at(x, map.height - 1 - y))));
        for (int size = map.width / 2; size > 0; size /= 2) {
            const std::vector<dvec4> finer = levels_.back();
            levels_.emplace_back();
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const auto at = std::size_t(2 * (2 * y * size + x)),
                               above = at + std::size_t(2 * size);
                    levels_.back().push_back(
                        0.25 * (finer[at] + finer[at + 1] + finer[above] + finer[above + 1]));
                }
        }
    }

    dvec4 mean(dvec2 centerUv, dvec2 widthUv) const {
        const int last = int(levels_.size()) - 1;
        const dvec2 texels = widthUv * std::exp2(last);
        const double level =
            std::clamp(0.5 * std::log2(std::max(texels.x * texels.y, 1.0)), 0.0, double(last));
        const int lower = std::min(int(level), last - 1);
        return glm::mix(filtered(lower, centerUv), filtered(lower + 1, centerUv), level - lower);
    }

private:
    dvec4 filtered(int level, dvec2 uv) const {
        const int size = 1 << (int(levels_.size()) - 1 - level);
        const dvec2 at = uv * double(size) - 0.5, part = at - glm::floor(at);
        const auto texel = [&](int x, int y) {
            const glm::ivec2 p =
                glm::clamp(glm::ivec2(glm::floor(at)) + glm::ivec2(x, y), 0, size - 1);
            return levels_[std::size_t(level)][std::size_t(p.y * size + p.x)];
        };
        return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x),
                        glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
    }

    std::vector<std::vector<dvec4>> levels_;  // from the finest; rows run upwards
};

// Plates parallel to the light, so that every cell is compared with the receiver's own depth.
// lit(mean warped moments, receiver's depth)
template <typename Lit>
void expectFrame(const std::string& estimate, double exponent, Lit lit) {
    constexpr int kMap = 256;
    constexpr double kWidth = 24.0 / kMap;
    const Rendered frame =
        render({.scene = sceneFile(platesScene()),
                .size = {128, 128},
                .settings = {"estimate=" + estimate, "exponent=100", "width=fixed", "map_size=256",
                             "filter_width=24", "constant_bias=0", "min_variance=1e-6"},
                .images = {"visibility", "receiver", {"shadow_map", {kMap, kMap}}}});
    const MipBoxes boxes(frame.at("shadow_map"), [&](double depth) {
        const double up = std::exp(exponent * depth);
        return dvec4(up, up * up, -1 / up, 1 / (up * up));
    });
    const Image &receivers = frame.at("receiver"), &visibility = frame.at("visibility");
    Image truth(visibility.width, visibility.height, 1, 1.0f),
        mask(visibility.width, visibility.height, 1);
    double compared = 0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            if (receivers.at(x, y, 3) <= 0) continue;
            const double depth = receivers.at(x, y, 2);
            const dvec2 uv(receivers.at(x, y, 0), receivers.at(x, y, 1));
            truth.at(x, y) = float(overCells(uv, dvec2(kWidth), 2, [&](dvec2 center, dvec2 cell) {
                return lit(boxes.mean(center, cell), depth);
            }));
            mask.at(x, y) = 1, compared += truth.at(x, y) > 0.02 && truth.at(x, y) < 0.98;
        }
    EXPECT_VALUE(compared, Greater, 500, "receivers of this scene that see a part of the light");
    EXPECT_IMAGE_NEAR(visibility, truth,
                      {.maximum = 4e-3,
                       .cause = estimate + ": the same boxes of the same map in float64; graphics "
                                           "cards filter with weights of 8 bits, half of which in "
                                           "two directions is 1/256 of a step"},
                      mask);
}

TEST(Task7Exponential, WholeFramesAreFilteredByTheWarps) {
    expectFrame("esm", 88, [](const dvec4& mean, double depth) {
        return std::min(mean.x * std::exp(-88 * depth), 1.0);
    });
    expectFrame("evsm", 42, [](const dvec4& mean, double depth) {
        const WarpedBox receiver{.depth = depth, .exponent = 42};
        return std::min(warpedBound({mean.x, mean.y}, receiver, 1, 1e-6),
                        warpedBound({mean.z, mean.w}, receiver, -1, 1e-6));
    });
}

}  // namespace
}  // namespace penumbra
