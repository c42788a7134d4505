#include "render/area_shadow_map.h"

#include <algorithm>

#include "render/light_frustum.h"
#include "render/passes.h"

namespace penumbra {

AreaShadowMap::AreaShadowMap(int size)
    : depth_({.size = glm::ivec2(size), .format = GL_DEPTH_COMPONENT32F, .label = "shadow map"}),
      framebuffer_({.depth = &depth_}) {
    const float nothing[] = {1.0f, 1.0f, 1.0f, 1.0f};
    glGenSamplers(1, &sampler_);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glSamplerParameteri(sampler_, wrap, GL_CLAMP_TO_BORDER);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glSamplerParameteri(sampler_, filter, GL_NEAREST);
    glSamplerParameterfv(sampler_, GL_TEXTURE_BORDER_COLOR, nothing);
}

AreaShadowMap::~AreaShadowMap() { glDeleteSamplers(1, &sampler_); }

// A texel at distance w is texelTangent w wide, and a step dw along the axis is dw / (w² (1/n -
// 1/f)) in depth. So `biasTexels` of them are biasTexels texelTangent / (w (1/n - 1/f)), where 1/w
// falls from 1/n at depth 0 to 1/f at depth 1.
void AreaShadowMap::fit(const View& view, float biasTexels) {
    const LightFrustum frustum = areaLightFrustum(view);
    const float texel = 1.0f / float(size());
    const float inverseNear = 1 / frustum.nearPlane, inverseFar = 1 / frustum.farPlane;
    const glm::vec2 tangents = frustum.tangents();
    const float bias =
        biasTexels * texel * std::max(tangents.x, tangents.y) / (inverseNear - inverseFar);
    values_ = {.clipFromWorld = frustum.clipFromView() * view.light.viewFromWorld(),
               .texelSizeUv = glm::vec2(texel),
               .widthScaleUv = frustum.widthScaleUv(view.light.width),
               .biasAtZero = bias * inverseNear,
               .biasSlope = bias * (inverseFar - inverseNear)};
    block_.upload(values_);
}

void AreaShadowMap::render(const View& view) const {
    const Program& opaque = view.shaders.program("area_shadow_map.vert", "depth.frag");
    const Program& masked = view.shaders.program("area_shadow_map.vert", "depth_masked.frag");
    bindBlock(opaque);
    bindBlock(masked);
    beginOpaquePass();
    framebuffer_.clear(glm::vec4(0), 1.0f);
    view.gpuScene.drawDepth(opaque, masked);
}

void AreaShadowMap::bind(const Program& program, int unit) const {
    bindBlock(program);
    program.use();
    program.texture("shadowMap", unit, depth_);
    glBindSampler(GLuint(unit), sampler_);
}

}  // namespace penumbra
