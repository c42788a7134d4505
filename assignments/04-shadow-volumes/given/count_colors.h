// Counts as colours over a picture.
#pragma once

#include "core/image.h"

namespace penumbra {

// Four channels, of the picture's size: 0 leaves its brightness in grey; 1, 2, 3, 4 and more have a
// colour each, and what is below 0 another. `wraps`: the counts are a stencil's, where 255 stands
// for -1.
Image countColors(const Image& picture, const Image& counts, bool wraps);

}  // namespace penumbra
