#include "core/frame_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "core/error.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

class FrameFileTest : public testing::Test {
protected:
    FrameFileTest()
        : folder(fs::path(testing::TempDir()) / ("frame_file_" + std::to_string(getpid()))) {
        fs::create_directories(folder);
    }
    ~FrameFileTest() override { fs::remove_all(folder); }

    // A file with this header and this many bytes of pixels.
    fs::path write(const std::string& header, std::size_t pixelBytes) const {
        return writeRaw("PENUMBRA1\n" + std::to_string(header.size()) + "\n" + header +
                        std::string(pixelBytes, '\0'));
    }
    fs::path writeRaw(const std::string& bytes) const {
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::string refusal(const fs::path& file, const FrameFileLimits& limits = {}) const {
        try {
            loadFrameFile(file, limits);
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    }

    fs::path folder;
    fs::path path = folder / "frame";
};

std::string header(const std::string& width, const std::string& height = "2",
                   const std::string& channels = "1") {
    return R"({"images":[{"name":"v","width":)" + width + R"(,"height":)" + height +
           R"(,"channels":)" + channels + "}]}";
}

TEST_F(FrameFileTest, ComesBackBitForBitWithNonFiniteValuesKept) {
    FrameFile frame;
    Image image(3, 2, 2, 0.25f);
    image.at(2, 1, 1) = std::numeric_limits<float>::quiet_NaN();
    image.at(0, 0, 0) = std::numeric_limits<float>::denorm_min();
    frame.images["visibility"] = image;
    frame.images["color"] = Image(1, 1, 4, -1.0f);
    frame.milliseconds["light"] = 1.5;
    frame.info["renderer"] = "llvmpipe \xff";
    saveFrameFile(path, frame);
    const FrameFile back = loadFrameFile(path);
    ASSERT_EQ(back.images.size(), 2u);
    EXPECT_TRUE(back.images.at("visibility").sameShape(image));
    EXPECT_EQ(std::memcmp(back.images.at("visibility").pixels.data(), image.pixels.data(), 48), 0);
    EXPECT_EQ(nonFiniteCount(back.images.at("visibility")), 1u);
    EXPECT_EQ(back.milliseconds.at("light"), 1.5);
    EXPECT_EQ(back.info.at("renderer"), "llvmpipe \xef\xbf\xbd");
    EXPECT_FALSE(fs::exists(folder / "frame.part"));
}

TEST_F(FrameFileTest, RefusesEveryTruncationAndTrailingBytes) {
    FrameFile frame;
    frame.images["v"] = Image(4, 4, 1, 1.0f);
    saveFrameFile(path, frame);
    std::ifstream stream(path, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(stream)), {});
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(refusal(writeRaw(whole.substr(0, length))), "accepted") << length;
    EXPECT_NE(refusal(writeRaw(whole + "x")).find("1 bytes follow"), std::string::npos);
    EXPECT_EQ(refusal(writeRaw(whole)), "accepted");
}

TEST_F(FrameFileTest, RefusesSizesThatAreNoSmallWholeNumbers) {
    EXPECT_EQ(refusal(write(header("2"), 16)), "accepted");
    for (const char* bad : {"-2", "0", "8193", "2147483648", "4294967298", "18446744073709551615",
                            "2.5", "1e999", "NaN", "null", "\"2\"", "[]"}) {
        EXPECT_NE(refusal(write(header(bad), 16)), "accepted") << bad;
        EXPECT_NE(refusal(write(header("2", bad), 16)), "accepted") << bad;
        EXPECT_NE(refusal(write(header("2", "2", bad), 16)), "accepted") << bad;
    }
    EXPECT_NE(refusal(write(header("2", "2", "5"), 80)), "accepted");
    EXPECT_NE(refusal(write(header("8192", "8192", "4"), 16)).find("cut short"), std::string::npos);
}

TEST_F(FrameFileTest, RefusesGarbageHeaders) {
    for (const char* bad :
         {"", "{", "[]", "{}", R"({"images":3})", R"({"images":[3]})", R"({"images":[{}]})",
          R"({"images":[{"name":3}]})", R"({"images":[],"milliseconds":{"light":-1}})",
          R"({"images":[],"milliseconds":{"light":1e999}})",
          R"({"images":[],"milliseconds":{"light":NaN}})",
          R"({"images":[],"milliseconds":{"light":null}})", R"({"images":[],"milliseconds":[]})",
          R"({"images":[],"info":{"a":1}})"})
        EXPECT_NE(refusal(write(bad, 0)), "accepted") << bad;
    EXPECT_EQ(refusal(write(R"({"images":[]})", 0)), "accepted");
    EXPECT_NE(refusal(writeRaw("PENUMBRA1\n-5\n")), "accepted");
    EXPECT_NE(refusal(writeRaw("PENUMBRA1\n99999999999999999999999\n")), "accepted");
    EXPECT_NE(refusal(writeRaw("PENUMBRA1\n1000000\n{}")), "accepted");
    EXPECT_NE(refusal(writeRaw("PENUMBRA2\n2\n{}")), "accepted");
    EXPECT_NE(refusal(writeRaw(std::string(4096, '\xff'))), "accepted");
    EXPECT_NE(refusal(write(std::string(500000, '['), 0)), "accepted");
}

TEST_F(FrameFileTest, RefusesTooManyImagesTwiceTheSameNameAndTooManyBytes) {
    const std::string one = R"({"name":"v","width":1,"height":1,"channels":1})";
    EXPECT_NE(refusal(write(R"({"images":[)" + one + "," + one + "]}", 8)), "accepted");
    std::string many = R"({"images":[)";
    for (int i = 0; i < 33; ++i)
        many += (i ? "," : "") + std::string(R"({"name":"v)") + std::to_string(i) +
                R"(","width":1,"height":1,"channels":1})";
    EXPECT_NE(refusal(write(many + "]}", 33 * 4)).find("33 images"), std::string::npos);
    EXPECT_NE(refusal(write(header("2"), 16), {.maximumBytes = 20}).find("more than the 20"),
              std::string::npos);
}

TEST_F(FrameFileTest, RefusesWhatIsNoRegularFile) {
    EXPECT_NE(refusal(folder / "missing").find("no frame file"), std::string::npos);
    EXPECT_NE(refusal(folder).find("not a regular file"), std::string::npos);
    write(header("2"), 16);
    fs::create_symlink(path, folder / "link");
    EXPECT_NE(refusal(folder / "link").find("not a regular file"), std::string::npos);
}

TEST_F(FrameFileTest, ReportsAFolderItCannotWriteTo) {
    EXPECT_THROW(saveFrameFile(folder / "none" / "frame", FrameFile{}), Error);
}

}  // namespace
}  // namespace penumbra
