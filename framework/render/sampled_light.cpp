#include "render/sampled_light.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

glm::vec2 lightPoint(int i, int n) {
    const glm::vec2 cell(i % n, i / n);
    return (cell + (glm::vec2(cell.y, cell.x) + 0.5f) / float(n)) / float(n) - 0.5f;
}

SampledLight::SampledLight(const SampledLightDescription& description)
    : description_(description), map_(description.mapSize) {}

void SampledLight::render(const View& view, const ReceiverImages& receivers) {
    if (visibility_.size() != receivers.position.size()) {
        visibility_ =
            Texture({.size = receivers.position.size(), .format = GL_R32F, .label = "visibility"});
        framebuffer_ = Framebuffer({.colors = {&visibility_}});
    }
    framebuffer_.clear(glm::vec4(0));
    const Program& program = view.shaders.program("screen.vert", "light_sample.frag");
    const int n = std::max(1, int(std::lround(std::sqrt(float(description_.maps)))));
    for (int i = 0; i < n * n; ++i) {
        const glm::vec2 at = lightPoint(i, n);
        Light point = view.light;
        point.center = view.light.point(at.x, at.y);
        point.width *= 1e-3f;  // its map need not see around corners
        View seen{view.scene, view.gpuScene, view.camera,  point,
                  view.size,  view.settings, view.shaders, view.revision};
        map_.fit(seen, description_.biasTexels);
        map_.render(seen);
        light_.upload(lightBlock(point));
        light_.bind(program, "Light", 1);
        map_.bind(program, 0);
        program.texture("receiverPosition", 1, receivers.position);
        program.texture("receiverNormal", 2, receivers.lightHeight);
        program.set("weight", 1.0f / float(n * n));
        screen_.draw(program, framebuffer_, Mix::add);
        AreaShadowMap::release(0);
    }
}

}  // namespace penumbra
