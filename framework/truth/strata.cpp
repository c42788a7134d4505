#include "truth/strata.h"

#include <cmath>

#include "core/error.h"

namespace penumbra {

Strata makeStrata(int count) {
    EXPECTS(count >= 1);
    const int rows = int(std::lround(std::sqrt(double(count))));
    Strata strata;
    for (int row = 0; row < rows; ++row) {
        const int begin = int(std::int64_t(count) * row / rows);
        const int end = int(std::int64_t(count) * (row + 1) / rows);
        const double width = 1.0 / (end - begin);
        const double t = double(begin) / count - 0.5, height = double(end - begin) / count;
        for (int i = 0; i < end - begin; ++i) {
            strata.s.push_back(float(i * width - 0.5));
            strata.t.push_back(float(t));
            strata.width.push_back(float(width));
            strata.height.push_back(float(height));
        }
    }
    return strata;
}

}  // namespace penumbra
