#include "moment_map.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

// As fine as the widest window allows: sums over a box stay below 2^31. 16-bit values are whole
// numbers of 1/65535, so that finer integers would tell nothing, and theirs are exact.
float integersPerUnit(const Settings& settings, const AreaShadowMap& map) {
    if (settings.chosen("prefilter") == "sat_cpu") return 0;
    const glm::vec2 widest = map.values().widthScaleUv * float(map.size());
    const glm::vec2 fixed = glm::vec2(2 * settings["filter_radius"]);
    const glm::vec2 sides = glm::min(glm::max(widest, fixed) + 2.0f, glm::vec2(float(map.size())));
    const float finest = std::exp2(30.0f - std::ceil(std::log2(sides.x * sides.y)));
    return settings.chosen("storage") == "float32" ? finest : std::min(finest, 65535.0f);
}

}  // namespace

float MomentMap::prepare(const Settings& settings, const AreaShadowMap& map) {
    const GLenum format = settings.chosen("storage") == "float32" ? GL_RGBA32F : GL_RGBA16;
    const float integers = integersPerUnit(settings, map);
    const bool resized = !image_ || image_->texture.size().x != map.size();
    if (resized || image_->texture.format() != format)
        image_ = std::make_unique<Image>(map.size(), format);
    if (resized || integers != integersPerUnit_)
        table_ = std::make_unique<SummedAreaTable>(SummedAreaTableDescription{
            .size = glm::ivec2(map.size()), .channels = 4, .integersPerUnit = integers});
    integersPerUnit_ = integers;
    return integers > 0 ? 1 / integers : 1;
}

void MomentMap::render(ShaderLibrary& shaders, const Settings& settings, const AreaShadowMap& map,
                       const ScreenTriangle& screen) const {
    const Program& program = shaders.program("screen.vert", "moments.frag",
                                             {"storage_" + settings.chosen("storage") + ".glsl"});
    program.use();
    program.texture("depths", 0, map.depth());
    screen.draw(program, image_->framebuffer);
}

}  // namespace penumbra
