#include "truth/strata.h"

#include <gtest/gtest.h>

namespace penumbra {

TEST(Strata, TileTheSquareWithEqualAreas) {
    for (const int count : {1, 2, 3, 5, 7, 16, 100, 101, 1024, 65536}) {
        const auto strata = makeStrata(count);
        ASSERT_EQ(strata.size(), std::size_t(count));
        double area = 0.0;
        for (const Stratum& cell : strata) {
            // Width and height are rounded to float: relative 2^-24 each.
            EXPECT_NEAR(double(cell.width) * double(cell.height) * count, 1.0, 2e-7);
            area += double(cell.width) * double(cell.height);
            EXPECT_GE(cell.s, -0.5f);
            EXPECT_GE(cell.t, -0.5f);
            EXPECT_LE(cell.s + cell.width, 0.5f + 1e-6f);  // two float additions
            EXPECT_LE(cell.t + cell.height, 0.5f + 1e-6f);
        }
        EXPECT_NEAR(area, 1.0, 2e-7);
    }
}

TEST(Strata, AreNearlySquare) {
    for (int count = 4; count < 300; ++count)
        for (const Stratum& cell : makeStrata(count)) {
            EXPECT_LT(cell.width, 2.01f * cell.height) << count;
            EXPECT_LT(cell.height, 2.01f * cell.width) << count;
        }
}

}  // namespace penumbra
