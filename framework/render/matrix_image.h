// A matrix as an image that a frame can hand over: how C++ functions are looked at and graded.
//
//   frame.output("clip_from_view", matrixImage(clipFromView));   // 4x4, one channel
//   float m12 = image.at(2, 1);                                  // row by row: at(column, row)
#pragma once

#include <glm/glm.hpp>

#include "core/image.h"

namespace penumbra {

inline Image matrixImage(const glm::mat4& m) {
    Image image(4, 4, 1);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) image.at(column, row) = m[column][row];
    return image;
}

}  // namespace penumbra
