// Moments of a shadow map, and what makes the mean over any box of them cheap.
//
//   float center = maps.center(view, map, screen);
//   maps.renderMoments(view, map, screen, block);
//   maps.prefilter(view, screen, block, integersPerUnit);   // table, integers or mip levels
//   maps.bind(program, 5);
#pragma once

#include <optional>

#include "render/deferred.h"
#include "render/summed_area_table.h"
#include "variance_shadow.h"

namespace penumbra {

class MomentMaps {
public:
    explicit MomentMaps(int size);  // texels along each side

    // Depth that is subtracted from all depths before they are squared.
    float center(const View& view, const AreaShadowMap& map, const ScreenTriangle& screen) const;
    void renderMoments(const View& view, const AreaShadowMap& map, const ScreenTriangle& screen,
                       const UniformBuffer<VarianceShadowBlock>& block) const;
    void renderWarped(const View& view, const AreaShadowMap& map, const ScreenTriangle& screen,
                      const UniformBuffer<VarianceShadowBlock>& block);
    // What the setting `prefilter` asks for, of the moments.
    void prefilter(const View& view, const ScreenTriangle& screen,
                   const UniformBuffer<VarianceShadowBlock>& block, float integersPerUnit);

    // For programs that ask for boxes; 2 texture units.
    void bind(const Program& program, int firstUnit) const;

    int size() const { return moments_.texture.size().x; }
    const Texture& moments() const { return moments_.texture; }
    const Texture& warped() const { return warped_->texture; }  // estimate=esm, evsm
    // The table's integers in floats, the upper and the lower 16 bits of each.
    const Texture& integers(const View& view, const ScreenTriangle& screen);

private:
    struct Target {
        Target(int size, GLenum format, const char* label, bool mipmaps = false)
            : texture({.size = glm::ivec2(size),
                       .format = format,
                       .filter = GLenum(mipmaps ? GL_LINEAR : GL_NEAREST),
                       .mipmaps = mipmaps,
                       .label = label}),
              framebuffer({.colors = {&texture}}) {}
        Texture texture;
        Framebuffer framebuffer;
    };
    void sumOnGpu(const View& view, const ScreenTriangle& screen,
                  const UniformBuffer<VarianceShadowBlock>& block);

    Target center_, moments_;
    std::optional<Target> warped_, halves_;
    std::optional<Target> sums_[2];  // of the fragment passes, taking turns
    std::optional<SummedAreaTable> table_;
    float integersPerUnit_ = 0;             // of table_
    const Texture* prefiltered_ = nullptr;  // table or levels
};

}  // namespace penumbra
