#include "render/summed_area_table.h"

#include <array>
#include <cmath>

#include "core/error.h"

namespace penumbra {

namespace {

GLenum formatOf(const SummedAreaTableDescription& d) {
    const bool integers = d.integersPerUnit > 0;
    switch (d.channels) {
        case 1:
            return integers ? GL_R32UI : GL_R32F;
        case 2:
            return integers ? GL_RG32UI : GL_RG32F;
        default:
            return integers ? GL_RGBA32UI : GL_RGBA32F;
    }
}

// `Sum` is what is added up; `Stored` what a texel keeps of it.
template <int channels, typename Sum, typename Stored, typename Convert>
void sumRows(const std::vector<float>& values, glm::ivec2 size, std::vector<Stored>& table,
             Convert convert) {
    const std::size_t width = std::size_t(size.x) * channels;
    std::vector<Sum> below(width, Sum(0));  // all rows up to the current one
    for (std::size_t row = 0; row < std::size_t(size.y); ++row) {
        std::array<Sum, channels> left{};
        for (std::size_t i = 0; i < width; i += channels)
            for (std::size_t c = 0; c < channels; ++c) {
                left[c] += convert(values[row * width + i + c]);
                below[i + c] += left[c];
                table[row * width + i + c] = Stored(below[i + c]);
            }
    }
}

template <typename Sum, typename Stored, typename Convert>
void sumRows(const std::vector<float>& values, const SummedAreaTableDescription& d,
             std::vector<Stored>& table, Convert convert) {
    table.resize(values.size());
    if (d.channels == 1) sumRows<1, Sum>(values, d.size, table, convert);
    if (d.channels == 2) sumRows<2, Sum>(values, d.size, table, convert);
    if (d.channels == 4) sumRows<4, Sum>(values, d.size, table, convert);
}

}  // namespace

SummedAreaTable::SummedAreaTable(const SummedAreaTableDescription& description)
    : description_(description),
      texture_({.size = description.size,
                .format = formatOf(description),
                .filter = description.integersPerUnit > 0 ? GLenum(GL_NEAREST) : GLenum(GL_LINEAR),
                .wrap = GL_CLAMP_TO_BORDER,
                .label = "summed-area table"}) {
    EXPECTS(description.channels == 1 || description.channels == 2 || description.channels == 4);
}

// Sums are kept in double: float32 would lose a bit at every addition, not only at the last one.
void SummedAreaTable::sum(const Texture& values) {
    EXPECTS(values.size() == description_.size && values.channels() == description_.channels);
    const std::vector<float> texels = values.readTexels();
    if (const double scale = description_.integersPerUnit; scale > 0) {
        sumRows<std::uint32_t>(texels, description_, integers_, [scale](float v) {
            return std::uint32_t(std::int64_t(std::floor(double(v) * scale + 0.5)));
        });
        texture_.uploadTexels(std::span<const std::uint32_t>(integers_));
    } else {
        sumRows<double>(texels, description_, floats_, [](float v) { return double(v); });
        texture_.uploadTexels(std::span<const float>(floats_));
    }
}

}  // namespace penumbra
