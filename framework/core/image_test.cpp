#include "core/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/test_folder.h"

namespace penumbra {
namespace {

using testing::TestFolder;

Image ramp(int channels) {
    Image image(5, 3, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = 0.37f * float(i) - 1.0f;
    return image;
}

TEST(Image, RowsFollowEachOtherAndChannelsAreInterleaved) {
    Image image(4, 2, 3);
    image.at(1, 1, 2) = 7;
    EXPECT_EQ(image.pixels[(4 + 1) * 3 + 2], 7.0f);
}

TEST(Image, ExrKeepsEveryBit) {
    const TestFolder folder;
    for (int channels = 1; channels <= 4; ++channels) {
        Image image = ramp(channels);
        image.pixels[0] = std::numeric_limits<float>::denorm_min();
        image.pixels[1] = std::numeric_limits<float>::infinity();
        saveExr(folder / "a.exr", image);
        const Image loaded = loadExr(folder / "a.exr");
        ASSERT_TRUE(loaded.sameShape(image)) << channels;
        EXPECT_EQ(std::memcmp(loaded.pixels.data(), image.pixels.data(), 4 * image.pixels.size()),
                  0);
    }
}

TEST(Image, AFileThatIsNoExrIsAnErrorThatNamesIt) {
    const TestFolder folder;
    const auto file = folder.write("a.exr", "not an image");
    try {
        loadExr(file);
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos);
    }
    EXPECT_THROW(loadExr(folder / "missing.exr"), Error);
}

TEST(Image, AFailedSaveLeavesNothing) {
    const TestFolder folder;
    EXPECT_THROW(saveExr(folder / "missing" / "a.exr", ramp(1)), Error);
    EXPECT_THROW(savePng(folder / "missing" / "a.png", ramp(3), Encoding::srgb), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Image, PngStartsWithItsSignature) {
    const auto png = encodePng(ramp(2), Encoding::linear);
    ASSERT_GT(png.size(), 8u);
    EXPECT_EQ(std::memcmp(png.data(), "\x89PNG\r\n\x1a\n", 8), 0);
}

TEST(Image, NonFiniteValuesAreCounted) {
    Image image = ramp(1);
    image.at(0, 0) = std::nanf("");
    image.at(1, 0) = -std::numeric_limits<float>::infinity();
    EXPECT_EQ(nonFiniteCount(image), 2u);
}

TEST(FalseColor, IsBlueWhereTooDarkWhiteWhereEqualRedWhereTooLight) {
    Image mine(3, 1, 1), truth(3, 1, 1);
    mine.pixels = {0, 0.5f, 1};
    truth.pixels = {1, 0.5f, 0};
    const Image color = falseColorDifference(mine, truth);
    EXPECT_EQ(color.pixels, (std::vector<float>{0, 0, 1, 1, 1, 1, 1, 0, 0}));
}

TEST(Error, IsOneLineForAPerson) {
    EXPECT_STREQ(Error("cannot open model\n", "a.glb ", "check the path").what(),
                 "cannot open model: a.glb; check the path");
}

}  // namespace
}  // namespace penumbra
