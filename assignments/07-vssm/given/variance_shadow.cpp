#include "variance_shadow.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

// A box's sum must stay below 2^31, and a texel's value is at most 1. Finer than 2^-22 a float of
// that size is not.
float integersPerUnit(float widestBoxTexels, int mapSize) {
    const float width = std::min(widestBoxTexels + 1, float(mapSize));
    return std::exp2(std::floor(std::min(31 - 2 * std::log2(width), 22.0f)));
}

}  // namespace

VarianceShadowBlock varianceShadowBlock(const Settings& s, const AreaShadowMap& map) {
    const float size = float(map.size()), fixed = s["filter_width"];
    const glm::vec2 searched = map.values().widthScaleUv * size;
    return {
        .filterWidthUv = glm::vec2(fixed / size),
        .leastWidthUv = glm::vec2(s["least_width"] / size),
        .queries = s.index("queries"),
        .searchCells = s.index("search_cells"),
        .filterCells = s.index("filter_cells"),
        .center = 0,
        .minVariance = s["min_variance"],
        .lightBleeding = s["light_bleeding"],
        .exponent = s["exponent"],
        .integersPerUnit = integersPerUnit(std::max({searched.x, searched.y, fixed}), map.size()),
        .mapSize = size};
}

bool isExponential(const Settings& s) {
    return s.chosen("estimate") == "esm" || s.chosen("estimate") == "evsm";
}

bool hasIntegers(const Settings& s) {
    return s.chosen("prefilter") == "sat_cpu_integer" || s.chosen("prefilter") == "sat_gpu";
}

std::vector<std::string> chunksFor(const Settings& s) {
    return {
        "receiver_visibility.glsl", "width_" + s.chosen("width") + ".glsl",
        "estimate_" + s.chosen("estimate") + ".glsl",
        hasIntegers(s) ? "prefilter_integer.glsl" : "prefilter_" + s.chosen("prefilter") + ".glsl"};
}

}  // namespace penumbra
