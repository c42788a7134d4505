// The dials as the shaders read them, and the chunks that they choose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/area_shadow_map.h"

namespace penumbra {

struct VarianceShadowBlock {  // variance_shadow.glsl
    glm::vec2 filterWidthUv, leastWidthUv;
    int queries, searchCells, filterCells;
    float center;
    float minVariance, lightBleeding, exponent, integersPerUnit;
    float mapSize, padding[3] = {};
};
static_assert(offsetof(VarianceShadowBlock, queries) == 16 &&
              offsetof(VarianceShadowBlock, center) == 28 &&
              offsetof(VarianceShadowBlock, integersPerUnit) == 44 &&
              sizeof(VarianceShadowBlock) == 64);

// All but `center`, which is in the map.
VarianceShadowBlock varianceShadowBlock(const Settings& settings, const AreaShadowMap& map);

// One form of every function that variance_shadow.glsl declares.
std::vector<std::string> chunksFor(const Settings& settings);

bool isExponential(const Settings& settings);  // estimate=esm, evsm
bool hasIntegers(const Settings& settings);    // prefilter=sat_cpu_integer, sat_gpu

}  // namespace penumbra
