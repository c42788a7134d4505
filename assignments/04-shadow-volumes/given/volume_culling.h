// Which volumes need not be drawn, and where on the screen the rest can matter. Every test errs to
// the safe side only: with each of them on or off the picture is the same to the last bit.
//
//   VolumeCulling culling(view, clipFromWorld);
//   if (culling.skips(mesh, light)) continue;
//   PixelRectangle where = culling.reach(light);
#pragma once

#include "render/frame.h"

namespace penumbra {

struct PixelRectangle {
    glm::ivec2 lower{0}, size{0};  // OpenGL's pixels, row 0 at the bottom
};

class VolumeCulling {
public:
    VolumeCulling(const View& view, const glm::mat4& clipFromWorld);

    // As the settings cull_range, cull_view and cull_empty ask.
    bool skips(std::size_t mesh, const Light& light) const;
    // The pixels that the light's range reaches; all of them with scissor=off.
    PixelRectangle reach(const Light& light) const;

private:
    const View& view_;
    glm::mat4 clipFromWorld_;
    std::vector<Box> boxes_;              // by mesh
    std::vector<std::size_t> receivers_;  // meshes whose box the view can hold
};

}  // namespace penumbra
