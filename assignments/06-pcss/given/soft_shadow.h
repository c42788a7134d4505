// The dials as the shaders read them, and the chunks that they choose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/image.h"
#include "render/light_frustum.h"

namespace penumbra {

struct SoftShadowBlock {  // soft_shadow.glsl
    glm::mat4 clipFromWorld;
    glm::vec2 texelSizeUv;
    glm::vec2 widthScaleUv;
    glm::vec2 filterWidthUv;
    float biasAtZero, biasSlope;
    int searchSamples, filterSamples;
    float minTexelUv, padding = 0;
};
static_assert(offsetof(SoftShadowBlock, texelSizeUv) == 64 &&
              offsetof(SoftShadowBlock, filterWidthUv) == 80 &&
              offsetof(SoftShadowBlock, biasAtZero) == 88 &&
              offsetof(SoftShadowBlock, searchSamples) == 96 &&
              offsetof(SoftShadowBlock, minTexelUv) == 104);

SoftShadowBlock softShadowBlock(const View& view, const LightFrustum& frustum, int mapSize);

// One form of every function that soft_shadow.glsl declares.
std::vector<std::string> chunksFor(const Settings& settings);

// Nearest texel; depth 1 beyond the map's border: nothing blocks there.
GLuint mapSampler();

}  // namespace penumbra
