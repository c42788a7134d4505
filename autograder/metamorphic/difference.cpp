#include "metamorphic/difference.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace penumbra {

void Difference::count(float off, int x, int y) {
    any += off > 0;
    if (off > kVisible) ++visible, sum += off;
    if (off > most) most = off, where = {x, y};
}

Difference difference(const Image& a, const Image& b) {
    EXPECTS(a.sameShape(b));
    Difference result;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) result.count(std::abs(a.at(x, y) - b.at(x, y)), x, y);
    return result;
}

Difference shifted(const Image& a, const Image& b, int by) {
    const int width = a.width - by, height = a.height - by;
    Image from(width, height, 1), to(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            from.at(x, y) = a.at(x + by, y + by);
            to.at(x, y) = b.at(x, y);
        }
    return difference(from, to);
}

double meanDifference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
    return sum / double(a.pixels.size());
}

bool nearAnEdge(const Image& truth, const Receivers& receivers, int x, int y) {
    const auto facet = [&](int u, int v) {
        return receivers.facetNormals[std::size_t(v) * std::size_t(truth.width) + std::size_t(u)];
    };
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
            const int u = std::clamp(x + i, 0, truth.width - 1);
            const int v = std::clamp(y + j, 0, truth.height - 1);
            if (truth.at(u, v) != truth.at(x, y)) return true;
            if (std::max(std::abs(i), std::abs(j)) == 1 &&
                glm::dot(facet(u, v), facet(x, y)) < 0.999f)
                return true;
        }
    return false;
}

}  // namespace penumbra
