#include "truth/distance_cache.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/test_folder.h"
#include "scene/shapes.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::TestFolder;

const DistanceGrid kGrid{{-0.5f, -0.5f, -0.5f}, 0.125f, {16, 16, 16}};

std::vector<Mesh> cube() { return {box({0, 0, 0}, {1, 1, 1}, 0)}; }

std::vector<fs::path> files(const TestFolder& folder) {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(folder / "distance-fields"))
        result.push_back(entry.path());
    return result;
}

// The cache's only file with one byte of its values turned: what comes back tells whether the file
// was believed.
void change(const fs::path& path, std::streamoff byte) {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(byte);
    const char before = char(file.get());
    file.seekp(byte);
    file.put(char(before ^ 1));
}

TEST(DistanceCache, GivesTheSameBits) {
    const TestFolder folder;
    const DistanceField truth = distanceField(cube(), kGrid);
    for (int i = 0; i < 2; ++i) {
        Progress progress("test", kGrid.size.z, true);
        const DistanceField field = cachedDistanceField(folder.path(), cube(), kGrid, &progress);
        EXPECT_EQ(field.values, truth.values);
        EXPECT_EQ(field.grid, kGrid);
        EXPECT_EQ(progress.fraction(), 1.0);
        EXPECT_EQ(files(folder).size(), 1u);
    }
}

TEST(DistanceCache, IsReadAndNotMadeAgain) {
    const TestFolder folder;
    cachedDistanceField(folder.path(), cube(), kGrid);
    Progress progress("test", 1, true);
    progress.cancelled = true;  // making it would come back empty
    EXPECT_FALSE(cachedDistanceField(folder.path(), cube(), kGrid, &progress).values.empty());
}

TEST(DistanceCache, KeepsApartWhatDiffers) {
    const TestFolder folder;
    DistanceGrid finer = kGrid;
    finer.cell *= 0.5f;
    std::vector<Mesh> moved = cube(), turned = cube(), open = cube();
    moved[0].positions[3].x += 1e-6f;
    std::swap(turned[0].triangles[0].x, turned[0].triangles[0].y);
    open[0].triangles.pop_back();
    cachedDistanceField(folder.path(), cube(), kGrid);
    cachedDistanceField(folder.path(), cube(), finer);
    for (const auto& meshes : {moved, turned, open})
        EXPECT_EQ(cachedDistanceField(folder.path(), meshes, kGrid).values,
                  distanceField(meshes, kGrid).values);
    EXPECT_EQ(files(folder).size(), 5u);
}

TEST(DistanceCache, IgnoresDamagedFiles) {
    const DistanceField truth = distanceField(cube(), kGrid);
    for (const std::streamoff byte : {0, 9, 17, 24, 2000, 16407}) {
        const TestFolder folder;
        cachedDistanceField(folder.path(), cube(), kGrid);
        ASSERT_EQ(fs::file_size(files(folder)[0]), 16408u);
        change(files(folder)[0], byte);
        EXPECT_EQ(cachedDistanceField(folder.path(), cube(), kGrid).values, truth.values) << byte;
        Progress progress("test", 1, true);
        progress.cancelled = true;
        EXPECT_FALSE(cachedDistanceField(folder.path(), cube(), kGrid, &progress).values.empty())
            << "written anew";
    }
}

TEST(DistanceCache, IgnoresFilesCutShort) {
    const TestFolder folder;
    cachedDistanceField(folder.path(), cube(), kGrid);
    for (const std::uintmax_t size : {0, 10, 24, 16000}) {
        fs::resize_file(files(folder)[0], size);
        EXPECT_EQ(cachedDistanceField(folder.path(), cube(), kGrid).values,
                  distanceField(cube(), kGrid).values);
    }
}

TEST(DistanceCache, LetsTheLeastRecentlyUsedGo) {
    const TestFolder folder;
    DistanceGrid other = kGrid, third = kGrid;
    other.lower.x = -0.25f, third.lower.x = 0.0f;
    const auto keep = [&](const DistanceGrid& grid) {
        cachedDistanceField(folder.path(), cube(), grid, nullptr, 2 * 16408);
    };
    keep(kGrid);
    const fs::path first = files(folder)[0];
    fs::last_write_time(first, fs::file_time_type::clock::now() - std::chrono::hours(2));
    keep(other);
    EXPECT_EQ(files(folder).size(), 2u);
    for (const fs::path& path : files(folder))
        if (path != first)
            fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
    keep(kGrid);  // used: now `other` is the older one
    keep(third);
    EXPECT_EQ(files(folder).size(), 2u);
    EXPECT_TRUE(fs::exists(first));
}

TEST(DistanceCache, ThatCannotBeWrittenIsNoError) {
    const TestFolder folder;
    const fs::path file = folder.write("file", "no folder");
    EXPECT_EQ(cachedDistanceField(file, cube(), kGrid).values, distanceField(cube(), kGrid).values);
}

TEST(DistanceCache, KeepsNothingOfACancelledField) {
    const TestFolder folder;
    Progress progress("test", 1, true);
    progress.cancelled = true;
    EXPECT_TRUE(cachedDistanceField(folder.path(), cube(), kGrid, &progress).values.empty());
    EXPECT_FALSE(fs::exists(folder / "distance-fields"));
}

}  // namespace
}  // namespace penumbra
