// The holes of an alpha-masked material, looked up as OpenGL does with GL_LINEAR and GL_REPEAT at
// level 0.
//
//   AlphaMask mask(texture, material.alphaCutoff);
//   if (mask.isHole(uv)) …   // light passes, the camera sees through
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

class AlphaMask {
public:
    AlphaMask(const Texture2D& texture, float cutoff);  // cutoff > 0

    // Bilinear, repeating; texel centres lie at (i + 1/2) / size, row 0 at v = 0. In [0,1].
    double alpha(glm::dvec2 uv) const;

    bool isHole(glm::dvec2 uv) const { return alpha(uv) < double(cutoff_); }

private:
    int width_;
    int height_;
    float cutoff_;
    std::vector<std::uint8_t> alpha_;
};

}  // namespace penumbra
