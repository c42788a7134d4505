#include "truth/strata.h"

#include <gtest/gtest.h>

namespace penumbra {

TEST(Strata, TileTheSquareWithEqualAreas) {
    for (const int count : {1, 2, 3, 5, 7, 16, 100, 101, 1024, 65536}) {
        const auto strata = makeStrata(count);
        ASSERT_EQ(strata.size(), std::size_t(count));
        double area = 0.0;
        for (std::size_t i = 0; i < strata.size(); ++i) {
            // Width and height are rounded to float: relative 2^-24 each.
            EXPECT_NEAR(double(strata.width[i]) * double(strata.height[i]) * count, 1.0, 2e-7);
            area += double(strata.width[i]) * double(strata.height[i]);
            EXPECT_GE(strata.s[i], -0.5f);
            EXPECT_GE(strata.t[i], -0.5f);
            EXPECT_LE(strata.s[i] + strata.width[i], 0.5f + 1e-6f);  // two float additions
            EXPECT_LE(strata.t[i] + strata.height[i], 0.5f + 1e-6f);
        }
        EXPECT_NEAR(area, 1.0, 2e-7);
    }
}

TEST(Strata, AreNearlySquare) {
    for (int count = 4; count < 300; ++count) {
        const auto strata = makeStrata(count);
        for (std::size_t i = 0; i < strata.size(); ++i) {
            EXPECT_LT(strata.width[i], 2.01f * strata.height[i]) << count;
            EXPECT_LT(strata.height[i], 2.01f * strata.width[i]) << count;
        }
    }
}

}  // namespace penumbra
