// The dials as the shaders read them, and the chunks that they choose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/frame.h"

namespace penumbra {

struct MomentShadowBlock {  // moment_shadow.glsl
    glm::vec2 filterWidthUv;
    float momentBias;
    int refinements, cells;
    float unitsPerInteger;
    float padding[2] = {};
};
static_assert(offsetof(MomentShadowBlock, momentBias) == 8 &&
              offsetof(MomentShadowBlock, unitsPerInteger) == 20);

MomentShadowBlock momentShadowBlock(const Settings& settings, int mapSize);

// One form of every function that moment_shadow.glsl declares.
std::vector<std::string> chunksFor(const Settings& settings);

}  // namespace penumbra
