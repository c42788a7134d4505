#include "moment_maps.h"

namespace penumbra {

MomentMaps::MomentMaps(int size)
    : center_(1, GL_R32F, "center"), moments_(size, GL_RG32F, "moments", true) {}

float MomentMaps::center(const View& view, const AreaShadowMap& map,
                         const ScreenTriangle& screen) const {
    const std::string& chosen = view.settings.chosen("center");
    if (chosen != "mean") return chosen == "half" ? 0.5f : 0.0f;
    const Program& program = view.shaders.program("screen.vert", "center.frag");
    program.use();
    program.texture("shadowMap", 0, map.depth());
    screen.draw(program, center_.framebuffer);
    return center_.texture.readTexels()[0];
}

void MomentMaps::renderMoments(const View& view, const AreaShadowMap& map,
                               const ScreenTriangle& screen,
                               const UniformBuffer<VarianceShadowBlock>& block) const {
    const Program& program = view.shaders.program("screen.vert", "moments.frag");
    map.bind(program, 0);
    block.bind(program, "VarianceShadow", 3);
    screen.draw(program, moments_.framebuffer);
    AreaShadowMap::release(0);
}

void MomentMaps::renderWarped(const View& view, const AreaShadowMap& map,
                              const ScreenTriangle& screen,
                              const UniformBuffer<VarianceShadowBlock>& block) {
    if (!warped_) warped_.emplace(size(), GL_RGBA32F, "warped moments", true);
    const Program& program =
        view.shaders.program("screen.vert", "warp_" + view.settings.chosen("estimate") + ".frag");
    map.bind(program, 0);
    block.bind(program, "VarianceShadow", 3);
    screen.draw(program, warped_->framebuffer);
    AreaShadowMap::release(0);
    warped_->texture.generateMipmaps();
}

void MomentMaps::prefilter(const View& view, const ScreenTriangle& screen,
                           const UniformBuffer<VarianceShadowBlock>& block, float integersPerUnit) {
    const std::string& chosen = view.settings.chosen("prefilter");
    if (chosen == "mipmap") {
        moments_.texture.generateMipmaps();
        prefiltered_ = &moments_.texture;
    } else if (chosen == "sat_gpu") {
        sumOnGpu(view, screen, block);
    } else {
        const float perUnit = hasIntegers(view.settings) ? integersPerUnit : 0;
        if (!table_ || perUnit != integersPerUnit_)
            table_.emplace(SummedAreaTableDescription{
                .size = glm::ivec2(size()), .channels = 2, .integersPerUnit = perUnit});
        integersPerUnit_ = perUnit;
        table_->sum(moments_.texture);
        prefiltered_ = &table_->texture();
    }
}

// First along rows, then along columns. After pass k each texel holds the sum of 4^(k+1) texels,
// itself and those before it; so many passes that this is at least the size.
void MomentMaps::sumOnGpu(const View& view, const ScreenTriangle& screen,
                          const UniformBuffer<VarianceShadowBlock>& block) {
    for (auto& sums : sums_)
        if (!sums) sums.emplace(size(), GL_RG32UI, "partial sums");
    const Program& toIntegers = view.shaders.program("screen.vert", "to_integers.frag");
    block.bind(toIntegers, "VarianceShadow", 3);
    toIntegers.use();
    toIntegers.texture("moments", 0, moments_.texture);
    screen.draw(toIntegers, sums_[0]->framebuffer);

    const Program& sum = view.shaders.program("screen.vert", "sum_pass.frag");
    int from = 0;
    for (const glm::vec2 axis : {glm::vec2(1, 0), glm::vec2(0, 1)})
        for (int pass = 0, summed = 1; summed < size(); ++pass, summed *= 4) {
            sum.use();
            sum.texture("partialSums", 0, sums_[from]->texture);
            sum.set("axis", axis);
            sum.set("pass", pass);
            from = 1 - from;
            screen.draw(sum, sums_[from]->framebuffer);
        }
    prefiltered_ = &sums_[from]->texture;
}

void MomentMaps::bind(const Program& program, int firstUnit) const {
    program.use();
    for (const char* name : {"table", "integers", "moments"})
        program.texture(name, firstUnit, *prefiltered_);
    if (warped_) program.texture("warped", firstUnit + 1, warped_->texture);
}

const Texture& MomentMaps::integers(const View& view, const ScreenTriangle& screen) {
    if (!halves_) halves_.emplace(size(), GL_RGBA32F, "summed-area table");
    const Program& program = view.shaders.program("screen.vert", "split_integers.frag");
    program.use();
    program.texture("integers", 0, *prefiltered_);
    screen.draw(program, halves_->framebuffer);
    return halves_->texture;
}

}  // namespace penumbra
