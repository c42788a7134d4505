#include "render/summed_area_table.h"

#include <gtest/gtest.h>

#include <random>

#include "gl/test_context.h"

namespace penumbra {
namespace {

class SummedAreaTableTest : public testing::GlTest {};

// 16-bit integers, as floats: exact in both.
Texture randomTexels(glm::ivec2 size, int channels, std::vector<float>& values) {
    std::mt19937 random(7);
    values.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(channels));
    for (float& v : values) v = float(random() & 0xffff);
    Texture texture({.size = size,
                     .format = channels == 1   ? GLenum(GL_R32F)
                               : channels == 2 ? GLenum(GL_RG32F)
                                               : GLenum(GL_RGBA32F)});
    texture.uploadTexels(std::span<const float>(values));
    return texture;
}

// Sum over texels x0 <= x < x1, y0 <= y < y1, modulo 2^32.
std::uint32_t boxSum(const std::vector<std::uint32_t>& table, int width, glm::ivec2 low,
                     glm::ivec2 high) {
    const auto corner = [&](int x, int y) {
        return x == 0 || y == 0
                   ? 0u
                   : table[std::size_t(y - 1) * std::size_t(width) + std::size_t(x - 1)];
    };
    return corner(high.x, high.y) - corner(low.x, high.y) - corner(high.x, low.y) +
           corner(low.x, low.y);
}

TEST_F(SummedAreaTableTest, FloatSumsAreExactWhereFloatsAre) {
    for (const int channels : {1, 2, 4}) {
        const glm::ivec2 size(13, 7);
        std::vector<float> values;
        const Texture texels = randomTexels(size, channels, values);
        SummedAreaTable table({.size = size, .channels = channels});
        table.sum(texels);
        const std::vector<float> sums = table.texture().readTexels();
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int c = 0; c < channels; ++c) {
                    double expected = 0;
                    for (int j = 0; j <= y; ++j)
                        for (int i = 0; i <= x; ++i)
                            expected += values[std::size_t((j * size.x + i) * channels + c)];
                    ASSERT_EQ(sums[std::size_t((y * size.x + x) * channels + c)], expected);
                }
    }
}

TEST_F(SummedAreaTableTest, IntegerSumsOfSmallBoxesAreExactInA4096Map) {
    const int size = 4096;
    std::vector<float> values;
    const Texture texels = randomTexels(glm::ivec2(size), 1, values);
    SummedAreaTable table({.size = glm::ivec2(size), .channels = 1, .integersPerUnit = 1});
    table.sum(texels);
    const std::vector<std::uint32_t> sums = table.texture().readIntegers();
    // The sum of all is about 5.5e11: the table has wrapped around more than a hundred times.
    std::mt19937 random(11);
    for (int trial = 0; trial < 1000; ++trial) {
        const glm::ivec2 extent(1 + int(random() % 128), 1 + int(random() % 128));
        const glm::ivec2 low(
            int(random() % unsigned(size - extent.x)),
            trial % 2 ? size - extent.y : int(random() % unsigned(size - extent.y)));
        std::uint64_t expected = 0;
        for (int y = low.y; y < low.y + extent.y; ++y)
            for (int x = low.x; x < low.x + extent.x; ++x)
                expected += std::uint64_t(values[std::size_t(y) * size + std::size_t(x)]);
        ASSERT_EQ(boxSum(sums, size, low, low + extent), expected);
    }
}

TEST_F(SummedAreaTableTest, NegativeValuesCountAsNegativeIntegers) {
    Texture texels({.size = {2, 1}, .format = GL_R32F});
    texels.uploadTexels(std::vector<float>{-0.5f, 0.25f});
    SummedAreaTable table({.size = {2, 1}, .channels = 1, .integersPerUnit = 1 << 20});
    table.sum(texels);
    const std::vector<std::uint32_t> sums = table.texture().readIntegers();
    EXPECT_EQ(std::int32_t(sums[0]), -(1 << 19));
    EXPECT_EQ(std::int32_t(sums[1]), -(1 << 18));
}

}  // namespace
}  // namespace penumbra
