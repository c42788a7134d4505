#include "render/deferred.h"

#include "render/passes.h"

namespace penumbra {

namespace {

Texture image(glm::ivec2 size, GLenum format, const char* label) {
    return Texture({.size = size, .format = format, .label = label});
}

}  // namespace

ReceiverImages::ReceiverImages(glm::ivec2 size)
    : unlit(image(size, GL_RGBA16F, "unlit color")),
      direct(image(size, GL_RGBA16F, "direct color")),
      position(image(size, GL_RGBA32F, "receiver position")),
      lightHeight(image(size, GL_RGBA32F, "light height")),
      depth(image(size, GL_DEPTH_COMPONENT32F, "camera depth")),
      framebuffer({.colors = {&unlit, &direct, &position, &lightHeight}, .depth = &depth}) {}

void ReceiverImages::render(const View& view, const Program& program) const {
    beginOpaquePass();
    framebuffer.clear(glm::vec4(0), 1.0f);
    framebuffer.clearColor(0, kBackground);
    framebuffer.clearColor(2, {0, 0, 0, -1});  // receivers.glsl: no surface
    view.gpuScene.draw(program);
}

void ReceiverImages::bind(const Program& program, int firstUnit) const {
    program.use();
    program.texture("receiverPosition", firstUnit, position);
    program.texture("receiverLightHeight", firstUnit + 1, lightHeight);
    program.texture("unlitColor", firstUnit + 2, unlit);
    program.texture("directColor", firstUnit + 3, direct);
}

ShadedImages::ShadedImages(glm::ivec2 size)
    : color(image(size, GL_RGBA16F, "color")),
      visibility(image(size, GL_R32F, "visibility")),
      framebuffer({.colors = {&color, &visibility}}) {}

ScreenTriangle::ScreenTriangle() { glGenVertexArrays(1, &vertexArray_); }
ScreenTriangle::~ScreenTriangle() { glDeleteVertexArrays(1, &vertexArray_); }

void ScreenTriangle::draw(const Program& program, const Framebuffer& target, Mix mix) const {
    glDisable(GL_DEPTH_TEST);
    if (mix == Mix::add) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    program.use();
    target.bind();
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

bool DeferredFrame::prepare(const View& view) {
    camera_.upload(cameraBlock(view.camera, view.size));
    light_.upload(lightBlock(view.light));
    if (receivers_ && receivers_->depth.size() == view.size) return false;
    receivers_.emplace(view.size);
    shaded_.emplace(view.size);
    return true;
}

void DeferredFrame::bindBlocks(const Program& program) const {
    camera_.bind(program, "Camera", 0);
    light_.bind(program, "Light", 1);
}

void DeferredFrame::output(Frame& frame) const {
    frame.output("color", shaded_->color);
    frame.output("visibility", shaded_->visibility);
    frame.output("depth", receivers_->depth);
    frame.output("receiver", receivers_->position);
    frame.output("light_height", receivers_->lightHeight);
}

}  // namespace penumbra
