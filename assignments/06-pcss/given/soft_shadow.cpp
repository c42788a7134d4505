#include "soft_shadow.h"

#include <algorithm>

namespace penumbra {

// A texel at distance w is texelTangent w wide, and a step dw along the axis is dw / (w² (1/n -
// 1/f)) in depth. So `texels` of them are texels texelTangent / (w (1/n - 1/f)), where 1/w falls
// from 1/n at depth 0 to 1/f at depth 1.
SoftShadowBlock softShadowBlock(const View& view, const LightFrustum& frustum, int mapSize) {
    const float texel = 1.0f / float(mapSize);
    const float inverseNear = 1 / frustum.nearPlane, inverseFar = 1 / frustum.farPlane;
    const glm::vec2 tangents = frustum.tangents();
    const float bias = view.settings["constant_bias"] * texel * std::max(tangents.x, tangents.y) /
                       (inverseNear - inverseFar);
    return {.clipFromWorld = frustum.clipFromView() * view.light.viewFromWorld(),
            .texelSizeUv = glm::vec2(texel),
            .widthScaleUv = frustum.widthScaleUv(view.light.width),
            .filterWidthUv = glm::vec2(2 * view.settings["pcf_radius"] * texel),
            .biasAtZero = bias * inverseNear,
            .biasSlope = bias * (inverseFar - inverseNear),
            .searchSamples = view.settings.index("search_samples"),
            .filterSamples = view.settings.index("filter_samples"),
            .minTexelUv = 1.0f};
}

std::vector<std::string> chunksFor(const Settings& s) {
    return {"method_" + s.chosen("method") + ".glsl", "kernel_" + s.chosen("kernel") + ".glsl",
            s.on("receiver_plane") ? "blocks_by_plane.glsl" : "blocks_by_depth.glsl",
            s.on("horizon") ? "horizon_on.glsl" : "horizon_off.glsl",
            s.on("pyramid") ? "window_narrowed.glsl" : "window_full.glsl"};
}

GLuint mapSampler() {
    const float nothing[] = {1.0f, 1.0f, 1.0f, 1.0f};
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glSamplerParameteri(sampler, wrap, GL_CLAMP_TO_BORDER);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glSamplerParameteri(sampler, filter, GL_NEAREST);
    glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, nothing);
    return sampler;
}

}  // namespace penumbra
