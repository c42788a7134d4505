#include "core/metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"

namespace penumbra {

Metrics compareVisibility(const Image& mine, const Image& truth, const Image* mask) {
    EXPECTS(mine.sameShape(truth) && mine.channels == 1);
    EXPECTS(!mask || mask->sameShape(truth));
    Metrics m;
    std::vector<float> absolute;
    absolute.reserve(truth.pixels.size());
    double squares = 0, sum = 0, penumbraSquares = 0;
    std::size_t penumbra = 0, lit = 0, umbra = 0, falseShadow = 0, lightLeak = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (mask && mask->pixels[i] == 0.0f) continue;
        const double t = truth.pixels[i], difference = mine.pixels[i] - t;
        absolute.push_back(float(std::abs(difference)));
        squares += difference * difference;
        sum += std::abs(difference);
        if (t > 0.98) {
            ++lit;
            falseShadow += mine.pixels[i] < 0.9f;
        } else if (t < 0.02) {
            ++umbra;
            lightLeak += mine.pixels[i] > 0.1f;
        } else {
            ++penumbra;
            penumbraSquares += difference * difference;
        }
    }
    m.count = absolute.size();
    if (m.count == 0) return m;
    const auto share = [](std::size_t part, std::size_t whole) {
        return whole ? double(part) / double(whole) : 0.0;
    };
    m.rmse = std::sqrt(squares / double(m.count));
    m.meanAbsolute = sum / double(m.count);
    m.penumbraRmse = penumbra ? std::sqrt(penumbraSquares / double(penumbra)) : 0.0;
    m.falseShadowRate = share(falseShadow, lit);
    m.lightLeakRate = share(lightLeak, umbra);
    m.maximum = *std::max_element(absolute.begin(), absolute.end());
    const auto p99 = absolute.begin() + std::ptrdiff_t(0.99 * double(m.count - 1));
    std::nth_element(absolute.begin(), p99, absolute.end());
    m.percentile99 = *p99;
    return m;
}

}  // namespace penumbra
