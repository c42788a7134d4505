// Passes that every technique shares, and the floor that every cost is measured against.
//
//   FloorPasses floor(1024);
//   floor.render(view);   // depth-only light pass + unshadowed forward pass: what any shadow must
//   add to
#pragma once

#include "gl/framebuffer.h"
#include "render/frame.h"
#include "render/uniforms.h"

namespace penumbra {

inline constexpr glm::vec4 kBackground{0.52f, 0.60f, 0.68f, 1.0f};  // linear; an overcast sky

// Depth test and write on, no blending, no culling: surfaces are two-sided.
void beginOpaquePass();

// A forward pass's images: colour (linear), visibility, depth.
struct CameraTargets {
    // Only those that the frame wants, and depth: with stencil where the format says so.
    CameraTargets(glm::ivec2 size, const Frame& frame, GLenum depthFormat = GL_DEPTH_COMPONENT32F);
    void clear() const;  // background colour, visibility 1, depth 1, stencil 0

    glm::ivec2 size;
    bool wantsColor, wantsVisibility;
    Texture color, visibility, depth;
    Framebuffer framebuffer;  // locations 0 colour, 1 visibility
    bool fits(glm::ivec2 otherSize, const Frame& frame) const;
};

class FloorPasses {
public:
    explicit FloorPasses(int mapSize);
    void render(const View& view);

private:
    Texture map_;
    Framebuffer light_;
    std::unique_ptr<CameraTargets> targets_;
    UniformBuffer<CameraBlock> cameraBlock_;
    UniformBuffer<LightBlock> lightBlock_;
};

}  // namespace penumbra
