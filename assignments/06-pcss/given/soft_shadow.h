// The dials as the shaders read them, and the chunks that they choose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/frame.h"

namespace penumbra {

struct SoftShadowBlock {  // soft_shadow.glsl
    glm::vec2 filterWidthUv;
    int searchSamples, filterSamples;
    float minTexelUv;
    float padding[3] = {};
};
static_assert(offsetof(SoftShadowBlock, searchSamples) == 8 &&
              offsetof(SoftShadowBlock, minTexelUv) == 16);

SoftShadowBlock softShadowBlock(const Settings& settings, int mapSize);

// One form of every function that soft_shadow.glsl declares.
std::vector<std::string> chunksFor(const Settings& settings);

}  // namespace penumbra
