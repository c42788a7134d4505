// Surfaces first, shadow after: visibility is computed once a pixel, whatever lies over what.
//
//   deferred.prepare(view);
//   deferred.bindBlocks(surfaces);                            // receivers.vert, receivers.frag
//   deferred.receivers().render(view, surfaces);
//   deferred.bindBlocks(shadow);                              // screen.vert, shadow_pass.frag
//   deferred.receivers().bind(shadow, 4);                     // texture units 4 to 7:
//   receivers.glsl deferred.screen().draw(shadow, deferred.shaded().framebuffer);
//   deferred.output(frame);
#pragma once

#include <glad/gl.h>

#include <optional>

#include "gl/framebuffer.h"
#include "render/frame.h"
#include "render/uniforms.h"

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

// All of these for one picture, and the blocks that their shaders read. Made while a context is
// current.
class DeferredFrame {
public:
    // Blocks of this view, images of its size. True where the images are new.
    bool prepare(const View& view);
    void bindBlocks(const Program& program) const;  // Camera at 0, Light at 1
    void output(Frame& frame) const;  // color, visibility, depth, receiver, light_height

    const ReceiverImages& receivers() const { return *receivers_; }
    const ShadedImages& shaded() const { return *shaded_; }
    const ScreenTriangle& screen() const { return screen_; }

private:
    UniformBuffer<CameraBlock> camera_;
    UniformBuffer<LightBlock> light_;
    ScreenTriangle screen_;
    std::optional<ReceiverImages> receivers_;
    std::optional<ShadedImages> shaded_;
};

}  // namespace penumbra
