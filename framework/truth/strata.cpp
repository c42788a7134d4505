#include "truth/strata.h"

#include <cmath>

#include "core/error.h"

namespace penumbra {

std::vector<Stratum> makeStrata(int count) {
    EXPECTS(count >= 1);
    const int rows = int(std::lround(std::sqrt(double(count))));
    std::vector<Stratum> strata;
    strata.reserve(std::size_t(count));
    for (int row = 0; row < rows; ++row) {
        const int begin = int(std::int64_t(count) * row / rows);
        const int end = int(std::int64_t(count) * (row + 1) / rows);
        const double width = 1.0 / (end - begin);
        const double t = double(begin) / count - 0.5, height = double(end - begin) / count;
        for (int i = 0; i < end - begin; ++i)
            strata.push_back({float(i * width - 0.5), float(t), float(width), float(height)});
    }
    return strata;
}

}  // namespace penumbra
