#include "count_colors.h"

#include <algorithm>
#include <glm/glm.hpp>

namespace penumbra {

namespace {

// 1, 2, 3, 4, 5 to 8, 9 to 16, more.
constexpr glm::vec3 kPalette[] = {
    {0.10f, 0.35f, 0.85f}, {0.05f, 0.65f, 0.45f}, {0.75f, 0.75f, 0.05f}, {0.95f, 0.45f, 0.02f},
    {0.85f, 0.08f, 0.04f}, {0.45f, 0.02f, 0.10f}, {0.10f, 0.00f, 0.02f}};
constexpr glm::vec3 kNegative{0.85f, 0.05f, 0.85f};

glm::vec3 colorOf(float count) {
    if (count < 0) return kNegative;
    const int steps[] = {1, 2, 3, 4, 8, 16};
    const auto* step = std::lower_bound(std::begin(steps), std::end(steps), int(count));
    return kPalette[step - std::begin(steps)];
}

}  // namespace

Image countColors(const Image& picture, const Image& counts, bool wraps) {
    Image result(picture.width, picture.height, 4, 1.0f);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            float count = counts.at(x, y);
            if (wraps && count >= 128) count -= 256;
            const float grey =
                (picture.at(x, y, 0) + picture.at(x, y, 1) + picture.at(x, y, 2)) / 3;
            const glm::vec3 color =
                count == 0 ? glm::vec3(grey)
                           : colorOf(count) * (0.35f + 0.65f * std::min(2 * grey, 1.0f));
            for (int c = 0; c < 3; ++c) result.at(x, y, c) = color[c];
        }
    return result;
}

}  // namespace penumbra
