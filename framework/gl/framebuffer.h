// Textures to draw into.
//
//   Framebuffer light({.depth = &shadowMap});
//   light.bind();                       // also sets the viewport to the attachments' size
//   light.clear({0, 0, 0, 0}, 1.0f);
#pragma once

#include <glad/gl.h>

#include <glm/glm.hpp>
#include <vector>

#include "gl/texture.h"

namespace penumbra {

struct FramebufferDescription {
    std::vector<const Texture*> colors =
        {};  // attachment i receives `layout(location = i) out`; null = thrown away
    const Texture* depth = nullptr;  // with its stencil, if its format has one
};

class Framebuffer {
public:
    Framebuffer() = default;
    explicit Framebuffer(const FramebufferDescription& description);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;

    void bind() const;
    // Binds, then clears every colour attachment to `color`, depth to `depth`, stencil to 0.
    void clear(glm::vec4 color, float depth = 1.0f) const;
    void clearColor(int attachment, glm::vec4 color) const;
    void clearStencil(int value = 0) const;
    // One channel, integers 0 to 255, row 0 on top. The depth attachment must have a stencil.
    Image readStencil() const;

    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
    glm::ivec2 size_{0};
    std::vector<bool> attached_;
    bool stencil_ = false;
};

}  // namespace penumbra
