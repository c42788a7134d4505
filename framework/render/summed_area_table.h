// Sums over everything to the left and below, so that four look-ups give the sum over any box.
// [Crow 1984] Computed on the CPU: read back, one pass, upload.
//
//   SummedAreaTable table({.size = {512, 512}, .channels = 2});
//   table.sum(moments);
//   program.texture("sums", 3, table.texture());
//
// Texel (i, j) holds the sum over texels (0 … i, 0 … j). So with F(x, y) the sum over all texels
// left of x and below y, in texels, F(i + 1, j + 1) is texel (i, j): linear filtering at
// ((x, y) - 1/2) / size gives F for any x, y from 0 to size, fractions included, because beyond the
// border the table is 0.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/texture.h"

namespace penumbra {

struct SummedAreaTableDescription {
    glm::ivec2 size{0};
    int channels = 2;  // 1, 2 or 4
    // 0: sums in float32, whose errors grow with the table. Otherwise each value v counts as the
    // integer round(v integersPerUnit), and sums are modulo 2^32: exact for every box that holds
    // less than 2^31 / (integersPerUnit max |v|) texels, however large the table.
    float integersPerUnit = 0;
};

class SummedAreaTable {
public:
    explicit SummedAreaTable(const SummedAreaTableDescription& description);
    void sum(const Texture& values);  // of the same size and channels

    // R/RG/RGBA 32F, linear; or 32UI, nearest.
    const Texture& texture() const { return texture_; }

private:
    SummedAreaTableDescription description_;
    Texture texture_;
    std::vector<float> floats_;
    std::vector<std::uint32_t> integers_;
};

}  // namespace penumbra
