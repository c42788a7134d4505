// Lists as images: rows of at most kRowLength values, one row after another, the last one filled up
// with 0.
#pragma once

#include <span>

#include "core/image.h"

namespace penumbra {

inline constexpr int kRowLength = 4095;  // whole triangles of three corners

// `values`: `channels` numbers for each entry of the list.
Image valueRows(std::span<const float> values, int channels = 1);

}  // namespace penumbra
