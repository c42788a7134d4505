#include "truth/alpha_mask.h"

#include <gtest/gtest.h>

namespace penumbra {

namespace {
// Alpha 0, 255 in the first row, 51, 102 in the second.
Texture2D fourTexels() { return {2, 2, {0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0, 51, 0, 0, 0, 102}}; }
}  // namespace

TEST(AlphaMask, TexelCentresHoldTheTexelsAndRowZeroIsAtVZero) {
    const AlphaMask mask(fourTexels(), 0.5f);
    EXPECT_DOUBLE_EQ(mask.alpha({0.25, 0.25}), 0.0);
    EXPECT_DOUBLE_EQ(mask.alpha({0.75, 0.25}), 1.0);
    EXPECT_DOUBLE_EQ(mask.alpha({0.25, 0.75}), 0.2);
    EXPECT_DOUBLE_EQ(mask.alpha({0.75, 0.75}), 0.4);
}

TEST(AlphaMask, IsBilinearBetweenCentresAndAcrossTheRepeat) {
    const AlphaMask mask(fourTexels(), 0.5f);
    EXPECT_NEAR(mask.alpha({0.375, 0.25}), 0.25, 1e-15);  // float64 rounding
    EXPECT_NEAR(mask.alpha({0.5, 0.5}), (0.0 + 1.0 + 0.2 + 0.4) / 4, 1e-15);
    EXPECT_NEAR(mask.alpha({0.0, 0.25}), 0.5, 1e-15);  // halfway from the last to the first column
    EXPECT_NEAR(mask.alpha({0.25, 1.0}), 0.1, 1e-15);
    EXPECT_NEAR(mask.alpha({-2.625, 3.25}), mask.alpha({0.375, 0.25}), 1e-15);
}

TEST(AlphaMask, HolesAreBelowTheCutoffOnly) {
    Texture2D texture{1, 1, {0, 0, 0, 51}};
    EXPECT_FALSE(AlphaMask(texture, 0.19f).isHole({0.3, 0.3}));
    EXPECT_TRUE(AlphaMask(texture, 0.21f).isHole({0.3, 0.3}));
}

}  // namespace penumbra
