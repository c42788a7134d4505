// The shadow map of an area light, seen from its centre, and how wide the light looks in it.
//
//   AreaShadowMap map(512);
//   map.fit(view, 1.0f);                  // frustum and bias: the block of area_shadow_map.glsl
//   map.render(view);                     // depth
//   map.bind(program, 0);                 // block ShadowMap, texture shadowMap
#pragma once

#include <cstddef>

#include "gl/framebuffer.h"
#include "render/frame.h"
#include "render/uniforms.h"

namespace penumbra {

struct ShadowMapBlock {  // area_shadow_map.glsl
    glm::mat4 clipFromWorld;
    glm::vec2 texelSizeUv;
    glm::vec2 widthScaleUv;
    float biasAtZero, biasSlope;
    glm::vec2 padding{0};
};
static_assert(offsetof(ShadowMapBlock, texelSizeUv) == 64 &&
              offsetof(ShadowMapBlock, widthScaleUv) == 72 &&
              offsetof(ShadowMapBlock, biasAtZero) == 80);

class AreaShadowMap {
public:
    explicit AreaShadowMap(int size);  // texels along each side
    ~AreaShadowMap();
    AreaShadowMap(const AreaShadowMap&) = delete;
    AreaShadowMap& operator=(const AreaShadowMap&) = delete;

    // `biasTexels`: the constant bias, in widths of a texel in the world where it applies.
    void fit(const View& view, float biasTexels);
    void render(const View& view) const;  // after fit()

    // For programs that read area_shadow_map.glsl. The texture is sampled at the nearest texel;
    // beyond the border depth is 1: nothing blocks there. The sampler stays at `unit` until
    // release().
    void bindBlock(const Program& program) const { block_.bind(program, "ShadowMap", 2); }
    void bind(const Program& program, int unit) const;
    static void release(int unit) { glBindSampler(GLuint(unit), 0); }

    int size() const { return depth_.size().x; }
    const Texture& depth() const { return depth_; }
    const ShadowMapBlock& values() const { return values_; }

private:
    Texture depth_;
    Framebuffer framebuffer_;
    GLuint sampler_ = 0;
    ShadowMapBlock values_{};
    UniformBuffer<ShadowMapBlock> block_;
};

}  // namespace penumbra
