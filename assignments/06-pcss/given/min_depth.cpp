#include "min_depth.h"

#include <algorithm>

namespace penumbra {

float MinDepth::prepare(int mapSize, glm::vec2 widestWindowUv) {
    constexpr int kSmallest = 16;  // texels of the image
    const float windowTexels = std::min(widestWindowUv.x, widestWindowUv.y) * float(mapSize);
    int halvings = 1;
    while (float(2 << halvings) <= 0.25f * windowTexels && (mapSize >> halvings) > kSmallest)
        ++halvings;
    if (mapSize != mapSize_ || halvings != halvings_) {
        levels_.clear();
        for (int i = 1; i <= halvings; ++i) levels_.emplace_back(mapSize >> i);
        for (int axis = 0; axis < 2; ++axis) levels_.emplace_back(mapSize >> halvings);
        mapSize_ = mapSize, halvings_ = halvings;
    }
    return float(1 << halvings) / float(mapSize);
}

void MinDepth::render(ShaderLibrary& shaders, const AreaShadowMap& map,
                      const ScreenTriangle& screen,
                      const UniformBuffer<SoftShadowBlock>& block) const {
    const Program& reduce = shaders.program("screen.vert", "min_reduce.frag");
    const Program& widen = shaders.program("screen.vert", "min_widen.frag");
    map.bindBlock(widen);
    block.bind(widen, "SoftShadow", 3);
    const Texture* source = &map.depth();
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool halves = int(i) < halvings_;
        const Program& program = halves ? reduce : widen;
        program.use();
        program.texture(halves ? "finer" : "narrow", 0, *source);
        if (!halves) program.set("axis", int(i) == halvings_ ? glm::vec2(1, 0) : glm::vec2(0, 1));
        screen.draw(program, levels_[i].framebuffer);
        source = &levels_[i].texture;
    }
}

}  // namespace penumbra
