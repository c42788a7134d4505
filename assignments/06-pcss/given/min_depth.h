// The smallest depth around each place in the shadow map.
//
//   float texel = minDepth.prepare(512, widthScaleUv);
//   minDepth.render(shaders, map, screen, block);
//   program.texture("minDepth", 5, *minDepth.image());
//
// The map is halved until a texel is about a quarter of the widest search window; then each texel
// takes the smallest value of all that such a window reaches from any of its points. So one look-up
// tells a receiver what its whole window holds at the nearest.
#pragma once

#include <vector>

#include "gl/framebuffer.h"
#include "render/area_shadow_map.h"
#include "render/deferred.h"
#include "soft_shadow.h"

namespace penumbra {

class MinDepth {
public:
    // Returns the width of a texel of the image [uv].
    float prepare(int mapSize, glm::vec2 widestWindowUv);
    void render(ShaderLibrary& shaders, const AreaShadowMap& map, const ScreenTriangle& screen,
                const UniformBuffer<SoftShadowBlock>& block) const;
    // Null before the first prepare().
    const Texture* image() const { return levels_.empty() ? nullptr : &levels_.back().texture; }

private:
    struct Level {
        explicit Level(int size)
            : texture({.size = glm::ivec2(size), .format = GL_R32F, .label = "min depth"}),
              framebuffer({.colors = {&texture}}) {}
        Texture texture;
        Framebuffer framebuffer;
    };
    int mapSize_ = 0, halvings_ = 0;
    std::vector<Level> levels_;  // the halvings, then the two widened along u, and along v
};

}  // namespace penumbra
