// Random numbers that are the same on every compiler and system (the standard's distributions are
// not): SplitMix64 [Steele, Lea, Flood 2014].
//
//   Random random(seed);
//   float height = random.between(0.5f, 2.8f);
#pragma once

#include <cstdint>

namespace penumbra {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

    // In [0, 1), 24 bits: every value is exact in a float.
    float unit() { return float(bits() >> 40) * (1.0f / 16777216.0f); }
    float between(float least, float most) { return least + (most - least) * unit(); }

private:
    std::uint64_t state_;
};

}  // namespace penumbra
