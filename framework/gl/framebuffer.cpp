#include "gl/framebuffer.h"

#include <cstdint>
#include <utility>

#include "core/error.h"

namespace penumbra {

Framebuffer::Framebuffer(const FramebufferDescription& description) {
    glGenFramebuffers(1, &id_);
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    std::vector<GLenum> drawBuffers;
    const auto attach = [&](GLenum point, const Texture& texture) {
        EXPECTS(size_ == glm::ivec2(0) || size_ == texture.size());
        size_ = texture.size();
        glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.id(), 0);
    };
    for (std::size_t i = 0; i < description.colors.size(); ++i) {
        const Texture* texture = description.colors[i];
        attached_.push_back(texture != nullptr);
        drawBuffers.push_back(texture ? GL_COLOR_ATTACHMENT0 + GLenum(i) : GLenum(GL_NONE));
        if (texture) attach(GL_COLOR_ATTACHMENT0 + GLenum(i), *texture);
    }
    stencil_ = description.depth && description.depth->hasStencil();
    if (description.depth)
        attach(stencil_ ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, *description.depth);
    if (drawBuffers.empty()) drawBuffers.push_back(GL_NONE);
    glDrawBuffers(GLsizei(drawBuffers.size()), drawBuffers.data());
    glReadBuffer(GL_NONE);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error("framebuffer is incomplete",
                    description.depth ? description.depth->label() : "colour",
                    "attach textures of formats that the driver can draw to");
}

Framebuffer::~Framebuffer() {
    if (id_) glDeleteFramebuffers(1, &id_);
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      size_(other.size_),
      attached_(std::move(other.attached_)),
      stencil_(other.stencil_) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(size_, other.size_);
    std::swap(attached_, other.attached_);
    std::swap(stencil_, other.stencil_);
    return *this;
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, size_.x, size_.y);
}

void Framebuffer::clear(glm::vec4 color, float depth) const {
    bind();
    glDepthMask(GL_TRUE);
    for (std::size_t i = 0; i < attached_.size(); ++i)
        if (attached_[i]) glClearBufferfv(GL_COLOR, GLint(i), &color.x);
    glClearBufferfv(GL_DEPTH, 0, &depth);
    if (stencil_) clearStencil();
}

void Framebuffer::clearStencil(int value) const {
    EXPECTS(stencil_);
    bind();
    glStencilMask(0xff);
    glClearBufferiv(GL_STENCIL, 0, &value);
}

Image Framebuffer::readStencil() const {
    EXPECTS(stencil_);
    bind();
    std::vector<std::uint8_t> values(std::size_t(size_.x) * std::size_t(size_.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
    Image image(size_.x, size_.y, 1);
    for (int y = 0; y < size_.y; ++y)  // OpenGL's row 0 is at the bottom
        for (int x = 0; x < size_.x; ++x)
            image.at(x, y) =
                float(values[std::size_t(size_.y - 1 - y) * std::size_t(size_.x) + std::size_t(x)]);
    return image;
}

void Framebuffer::clearColor(int attachment, glm::vec4 color) const {
    bind();
    if (attached_[std::size_t(attachment)]) glClearBufferfv(GL_COLOR, attachment, &color.x);
}

}  // namespace penumbra
