#include "render/passes.h"

#include <algorithm>
#include <glm/ext/matrix_clip_space.hpp>

namespace penumbra {

void beginOpaquePass() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

CameraTargets::CameraTargets(glm::ivec2 targetSize, const Frame& frame, GLenum depthFormat)
    : size(targetSize),
      wantsColor(frame.wants("color")),
      wantsVisibility(frame.wants("visibility")) {
    if (wantsColor) color = Texture({.size = size, .format = GL_RGBA16F, .label = "color"});
    if (wantsVisibility)
        visibility = Texture({.size = size, .format = GL_R32F, .label = "visibility"});
    depth = Texture({.size = size, .format = depthFormat, .label = "camera depth"});
    framebuffer = Framebuffer(
        {.colors = {wantsColor ? &color : nullptr, wantsVisibility ? &visibility : nullptr},
         .depth = &depth});
}

bool CameraTargets::fits(glm::ivec2 otherSize, const Frame& frame) const {
    return size == otherSize && wantsColor == frame.wants("color") &&
           wantsVisibility == frame.wants("visibility");
}

void CameraTargets::clear() const {
    framebuffer.clear(kBackground, 1.0f);
    framebuffer.clearColor(1, glm::vec4(1.0f));
}

FloorPasses::FloorPasses(int mapSize)
    : map_({.size = glm::ivec2(mapSize),
            .format = GL_DEPTH_COMPONENT32F,
            .label = "floor light depth"}),
      light_({.depth = &map_}) {}

void FloorPasses::render(const View& view) {
    const Frame frame({{"color"}});
    if (!targets_ || !targets_->fits(view.size, frame))
        targets_ = std::make_unique<CameraTargets>(view.size, frame);
    beginOpaquePass();

    // The scene's bounding sphere, seen whole from the light.
    const Box box = bounds(view.scene);
    const float distance = glm::length(box.center() - view.light.center),
                radius = 0.5f * box.diagonal();
    const float nearPlane = std::max(distance - radius, 0.01f * distance);
    const float side = nearPlane * std::min(radius / std::max(distance, 1e-6f), 1.5f);
    CameraBlock light;
    light.viewFromWorld = view.light.viewFromWorld();
    light.clipFromWorld =
        glm::frustum(-side, side, -side, side, nearPlane, distance + radius) * light.viewFromWorld;
    light.eye = view.light.center;
    cameraBlock_.upload(light);
    const Program& opaque = view.shaders.program("depth.vert", "depth.frag");
    const Program& masked = view.shaders.program("depth.vert", "depth_masked.frag");
    for (const Program* program : {&opaque, &masked}) cameraBlock_.bind(*program, "Camera", 0);
    light_.clear(glm::vec4(0), 1.0f);
    view.gpuScene.drawDepth(opaque, masked);

    const Program& shade = view.shaders.program("surface.vert", "unshadowed.frag");
    cameraBlock_.upload(cameraBlock(view.camera, view.size));
    lightBlock_.upload(lightBlock(view.light));
    cameraBlock_.bind(shade, "Camera", 0);
    lightBlock_.bind(shade, "Light", 1);
    targets_->clear();
    view.gpuScene.draw(shade);
}

}  // namespace penumbra
