#include "value_rows.h"

#include <algorithm>

namespace penumbra {

Image valueRows(std::span<const float> values, int channels) {
    const int entries = int(values.size()) / channels;
    const int width = std::clamp(entries, 1, kRowLength);
    Image image(width, std::max(1, (entries + width - 1) / width), channels);
    std::copy(values.begin(), values.end(), image.pixels.begin());
    return image;
}

}  // namespace penumbra
