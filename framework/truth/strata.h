// Any number of equal-area cells that tile the light's square, for stratified sampling.
//
//   std::vector<Stratum> strata = makeStrata(100);   // 10 x 10
//   std::vector<Stratum> seven = makeStrata(7);      // rows of 2, 2 and 3; each cell 1/7 of the
//   area
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra {

// Cell i is [s, s + width) x [t, t + height) of the square [-1/2, 1/2]². Arrays side by side, for
// SIMD.
struct Strata {
    std::vector<float> s, t, width, height;

    std::size_t size() const { return s.size(); }
};

// round(sqrt(count)) rows whose cell counts differ by one at most; a row is as high as its share of
// the cells, so that every cell has the same area and one jittered point in each gives an unbiased
// mean.
Strata makeStrata(int count);

// A well mixed hash of a counter [Wellons 2018, lowbias32]: no state, so a pixel's numbers depend
// on nothing but pixel, sample and seed; fixed shifts, so that compilers make vector code of it.
inline std::uint32_t mixBits(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

}  // namespace penumbra
