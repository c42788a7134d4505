#include "core/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

Image row(std::initializer_list<float> values) {
    Image image(int(values.size()), 1, 1);
    image.pixels.assign(values);
    return image;
}

TEST(Metrics, EqualImagesHaveNoError) {
    const Image image = row({0, 0.25f, 1, 1});
    const Metrics m = compareVisibility(image, image);
    EXPECT_EQ(m.count, 4u);
    EXPECT_EQ(m.rmse + m.meanAbsolute + m.maximum + m.percentile99 + m.penumbraRmse, 0.0);
    EXPECT_EQ(m.falseShadowRate + m.lightLeakRate, 0.0);
}

TEST(Metrics, OneWrongPixelOfFour) {
    const Metrics m = compareVisibility(row({1, 0, 1, 1}), row({0, 0, 1, 1}));
    EXPECT_DOUBLE_EQ(m.rmse, 0.5);
    EXPECT_DOUBLE_EQ(m.meanAbsolute, 0.25);
    EXPECT_DOUBLE_EQ(m.maximum, 1.0);
}

TEST(Metrics, LeakIsAShareOfTheUmbraAndFalseShadowOfTheLit) {
    const Metrics m = compareVisibility(row({0.5f, 0, 0.5f, 1, 1, 1}), row({0, 0, 1, 1, 1, 1}));
    EXPECT_DOUBLE_EQ(m.lightLeakRate, 0.5);
    EXPECT_DOUBLE_EQ(m.falseShadowRate, 0.25);
}

TEST(Metrics, PenumbraCountsOnItsOwn) {
    const Metrics m = compareVisibility(row({0.75f, 0.25f, 1, 0}), row({0.5f, 0.5f, 1, 0}));
    EXPECT_DOUBLE_EQ(m.penumbraRmse, 0.25);
    EXPECT_DOUBLE_EQ(m.rmse, std::sqrt(2 * 0.0625 / 4));
}

TEST(Metrics, MaskedPixelsAreLeftOut) {
    const Image mask = row({0, 1, 1, 1});
    const Metrics m = compareVisibility(row({1, 0, 1, 1}), row({0, 0, 1, 1}), &mask);
    EXPECT_EQ(m.count, 3u);
    EXPECT_EQ(m.maximum, 0.0);
}

TEST(Metrics, NothingLeftIsNoError) {
    const Image mask = row({0, 0});
    EXPECT_EQ(compareVisibility(row({1, 0}), row({0, 1}), &mask).count, 0u);
}

}  // namespace
}  // namespace penumbra
