#include "core/output_folder.h"

#include <gtest/gtest.h>

#include <iterator>

#include "core/error.h"
#include "core/test_folder.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::TestFolder;

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::ptrdiff_t entries(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(OutputFolder, CommittedFilesAreInPlaceAndNothingElse) {
    const TestFolder folder;
    {
        OutputFolder out(folder / "out");
        writeText(out.file("a.txt"), "one\n");
        EXPECT_FALSE(fs::exists(folder / "out" / "a.txt"));
        out.commit();
    }
    EXPECT_EQ(contents(folder / "out" / "a.txt"), "one\n");
    EXPECT_EQ(entries(folder / "out"), 1);
}

TEST(OutputFolder, WithoutCommitNothingStays) {
    const TestFolder folder;
    {
        const OutputFolder out(folder / "out");
        writeText(out.file("a.txt"), "one\n");
    }
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(OutputFolder, WithoutCommitOldFilesStayAsTheyWere) {
    const TestFolder folder;
    folder.write("out/a.txt", "old\n");
    {
        const OutputFolder out(folder / "out");
        writeText(out.file("a.txt"), "new\n");
    }
    EXPECT_EQ(contents(folder / "out" / "a.txt"), "old\n");
    EXPECT_EQ(entries(folder / "out"), 1);
}

TEST(OutputFolder, AFileInItsPlaceIsAnError) {
    const TestFolder folder;
    const auto file = folder.write("out", "");
    EXPECT_THROW(OutputFolder{file}, Error);
    EXPECT_EQ(entries(folder.path()), 1);
}

TEST(WriteText, ReplacesTheWholeFile) {
    const TestFolder folder;
    const auto file = folder.write("a.txt", "a longer text\n");
    writeText(file, "short\n");
    EXPECT_EQ(contents(file), "short\n");
    EXPECT_EQ(entries(folder.path()), 1);
}

TEST(WriteText, AFolderThatIsNotThereIsAnError) {
    const TestFolder folder;
    EXPECT_THROW(writeText(folder / "missing" / "a.txt", ""), Error);
}

}  // namespace
}  // namespace penumbra
