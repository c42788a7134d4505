// Surfaces first, shadow after: visibility is computed once a pixel, whatever lies over what.
//
//   receivers.render(view, view.shaders.program("receivers.vert", "receivers.frag"));
//   receivers.bind(shadow, 4);                   // texture units 4 to 7: receivers.glsl
//   screen.draw(shadow, shaded.framebuffer);     // screen.vert, shadow_pass.frag
#pragma once

#include <glad/gl.h>

#include "gl/framebuffer.h"
#include "render/frame.h"

namespace penumbra {

// One value a pixel, of the nearest surface. receivers.frag says what position and lightHeight
// hold; a technique without a shadow map may write its own there.
struct ReceiverImages {
    explicit ReceiverImages(glm::ivec2 size);
    // Clears, then draws the scene; the uniform blocks of `program` are bound.
    void render(const View& view, const Program& program) const;
    void bind(const Program& program, int firstUnit) const;

    Texture unlit, direct, position, lightHeight, depth;
    Framebuffer framebuffer;
};

struct ShadedImages {
    explicit ShadedImages(glm::ivec2 size);
    Texture color, visibility;
    Framebuffer framebuffer;
};

enum class Mix { replace, add };  // a pixel takes the new value, or adds it to the old one

// One triangle over the whole target: every pixel of it is written, nothing is tested.
class ScreenTriangle {
public:
    ScreenTriangle();
    ~ScreenTriangle();
    ScreenTriangle(const ScreenTriangle&) = delete;
    ScreenTriangle& operator=(const ScreenTriangle&) = delete;
    // `program`'s blocks, textures and uniforms are set.
    void draw(const Program& program, const Framebuffer& target, Mix mix = Mix::replace) const;

private:
    GLuint vertexArray_ = 0;
};

}  // namespace penumbra
