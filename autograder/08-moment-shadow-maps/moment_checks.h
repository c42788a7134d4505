// What the checks of moment shadow maps share: depths with known shares and their moments, and
// Hamburger's problem in float64. Depths z are in [-1,1].
#pragma once

#include <random>

#include "core/checks.h"
#include "scene/gallery.h"

namespace penumbra {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec4;
using Rows = std::vector<vec4>;

constexpr int kRows = 8192;

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
    int count(int low, int high) { return low + int(engine() % unsigned(high - low + 1)); }
};

// What lies nearer than some depth.
struct Below {
    double share = 0, sum = 0;  // of all; of their depths, each times its share
    double depth() const { return share > 0 ? sum / share : 0; }
};

// A few depths, each with its share of all; the shares add up to 1.
struct Distribution {
    std::vector<double> depths, shares;

    dvec4 moments() const;
    Below below(double t) const;  // nearer than t, t itself not
};

// Shares of at least `least` each.
std::vector<double> randomShares(Dice& dice, int count, double least = 0);
// One to six depths: anywhere, in pairs that are nearly one, at the ends, symmetric.
Distribution randomDistribution(Dice& dice);
// Ascending depths with a distance of at least `apart` from each other, and from ±1 if `inside`.
Distribution spread(Dice& dice, int count, double apart, bool inside = false);

// The moments of -1, 0 and 1 with shares 0.3, 0.4 and 0.3.
const dvec4 kBiasMoments{0, 0.6, 0, 0.6};
inline dvec4 biased(const dvec4& moments, double alpha) {
    return (1 - alpha) * moments + alpha * kBiasMoments;
}
Distribution biased(Distribution distribution, double alpha);

// How far float32 may be off in a share, with moments that are biased by alpha: the matrix of the
// moments has no eigenvalue below 0.168 alpha (0.168: that of -1, 0, 1 with shares 0.3, 0.4, 0.3),
// and an error e in it makes one of e / 0.168 / alpha in a share.
inline double shareRounding(double alpha) { return 4 * 6e-8 / (0.168 * alpha); }

// The three depths that have these moments, one of them t: the other two in order, and what is
// nearer than t. The moments' matrix must not be singular.
struct ThreePoints {
    dvec2 others;
    Below below;
};
ThreePoints threePoints(const dvec4& moments, double t);

}  // namespace penumbra
