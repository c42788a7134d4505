#include "truth/alpha_mask.h"

#include <cmath>

#include "core/error.h"

namespace penumbra {

AlphaMask::AlphaMask(const Texture2D& texture, float cutoff)
    : width_(texture.width), height_(texture.height), cutoff_(cutoff) {
    EXPECTS(width_ > 0 && height_ > 0 && cutoff > 0.0f);
    const std::size_t texels = std::size_t(width_) * std::size_t(height_);
    EXPECTS(texture.rgba.size() == 4 * texels);
    alpha_.resize(texels);
    for (std::size_t i = 0; i < texels; ++i) alpha_[i] = texture.rgba[4 * i + 3];
}

double AlphaMask::alpha(glm::dvec2 uv) const {
    const glm::dvec2 size(width_, height_);
    const glm::dvec2 position = (uv - glm::floor(uv)) * size - 0.5;  // repeat, then texel centres
    const glm::dvec2 corner = glm::floor(position);
    const glm::dvec2 part = position - corner;
    const auto wrap = [](int i, int count) {
        return i < 0 ? i + count : i >= count ? i - count : i;
    };
    const int x0 = wrap(int(corner.x), width_), x1 = wrap(int(corner.x) + 1, width_);
    const int y0 = wrap(int(corner.y), height_), y1 = wrap(int(corner.y) + 1, height_);
    const auto texel = [&](int x, int y) {
        return alpha_[std::size_t(y) * std::size_t(width_) + std::size_t(x)] / 255.0;
    };
    return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), part.x),
                    glm::mix(texel(x0, y1), texel(x1, y1), part.x), part.y);
}

}  // namespace penumbra
