#include "moment_checks.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

dvec4 Distribution::moments() const {
    dvec4 sum(0);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const double z = depths[i];
        sum += shares[i] * dvec4(z, z * z, z * z * z, z * z * z * z);
    }
    return sum;
}

Below Distribution::below(double t) const {
    Below below;
    for (std::size_t i = 0; i < depths.size(); ++i)
        if (depths[i] < t) below.share += shares[i], below.sum += shares[i] * depths[i];
    return below;
}

std::vector<double> randomShares(Dice& dice, int count, double least) {
    std::vector<double> shares;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += shares.emplace_back(-std::log(dice(1e-6, 1)));
    for (double& share : shares) share = least + (1 - least * count) * share / sum;
    return shares;
}

Distribution randomDistribution(Dice& dice) {
    Distribution d;
    const int count = dice.count(1, 6), kind = dice.count(0, 4);
    for (int i = 0; i < count; ++i) d.depths.push_back(dice(-1, 1));
    d.shares = randomShares(dice, count);
    for (int i = 0; i + 1 < count; i += 2) {
        const auto first = std::size_t(i), second = first + 1;
        if (kind == 1) d.depths[second] = std::min(d.depths[first] + dice(0, 1e-3), 1.0);
        if (kind == 2) d.depths[first] = i % 4 == 0 ? -1 : 1;
        if (kind == 3) {
            d.depths[second] = -d.depths[first];
            d.shares[first] = d.shares[second] = 0.5 * (d.shares[first] + d.shares[second]);
        }
    }
    return d;
}

Distribution spread(Dice& dice, int count, double apart, bool inside) {
    // Without the gaps any depths will do.
    const double gaps = apart * (count - 1 + (inside ? 2 : 0));
    Distribution d;
    for (int i = 0; i < count; ++i) d.depths.push_back(dice(-1, 1 - gaps));
    std::sort(d.depths.begin(), d.depths.end());
    for (int i = 0; i < count; ++i) d.depths[std::size_t(i)] += apart * (i + (inside ? 1 : 0));
    d.shares = randomShares(dice, count, 0.1);
    return d;
}

Distribution biased(Distribution d, double alpha) {
    for (double& share : d.shares) share *= 1 - alpha;
    d.depths.insert(d.depths.end(), {-1, 0, 1});
    d.shares.insert(d.shares.end(), {0.3 * alpha, 0.4 * alpha, 0.3 * alpha});
    return d;
}

ThreePoints threePoints(const dvec4& b, double t) {
    // The others are the roots of K(t, z) = (1, t, t²) B⁻¹ (1, z, z²), B the matrix of the moments.
    const glm::dmat3 moments(1, b.x, b.y, b.x, b.y, b.z, b.y, b.z, b.w);
    const dvec3 k = glm::inverse(moments) * dvec3(1, t, t * t);
    const double root = std::sqrt(std::max(k.y * k.y - 4 * k.z * k.x, 0.0));
    const double half = -0.5 * (k.y + std::copysign(root, k.y));
    const double far = half / k.z, near = k.x / half;
    const dvec2 others(std::min(far, near), std::max(far, near));
    // Shares by Lagrange's polynomial of each: it is 1 at one of the three, 0 at the others.
    const auto share = [&](double z, double p, double q) {
        return (b.y - (p + q) * b.x + p * q) / ((z - p) * (z - q));
    };
    Below below;
    for (int i = 0; i < 2; ++i)
        if (others[i] < t) {
            const double s = share(others[i], others[1 - i], t);
            below.share += s, below.sum += s * others[i];
        }
    return {others, below};
}

}  // namespace penumbra
