// Any number of equal-area cells that tile the light's square, for stratified sampling.
//
//   std::vector<Stratum> strata = makeStrata(100);   // 10 x 10
//   std::vector<Stratum> seven = makeStrata(7);      // rows of 2, 2 and 3; each cell 1/7 of the
//   area
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra {

// The cell [s, s + width) x [t, t + height) of the square [-1/2, 1/2]².
struct Stratum {
    float s, t, width, height;
};

// round(sqrt(count)) rows whose cell counts differ by one at most; a row is as high as its share of
// the cells, so that every cell has the same area and one jittered point in each gives an unbiased
// mean.
std::vector<Stratum> makeStrata(int count);

// PCG's output function on a counter [O'Neill 2014; Jarzynski and Olano 2020]: no state, so a
// pixel's numbers depend on nothing but pixel, sample and seed.
inline std::uint32_t pcgHash(std::uint32_t x) {
    x = x * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u;
    return (x >> 22) ^ x;
}

}  // namespace penumbra
