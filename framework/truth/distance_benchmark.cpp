// Seconds to make a distance field, and to take it from the cache.
//
//   penumbra-distance-benchmark [scene] [voxels] [repeats]     defaults: chandelier 128 3
//
// Of the meshes that possibleBlockers names. The first figure includes writing the cache, in a
// folder of its own that goes afterwards.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>

#include "scene/blockers.h"
#include "scene/gallery.h"
#include "truth/distance_cache.h"
#include "truth/parallel.h"

using namespace penumbra;
namespace fs = std::filesystem;

int main(int count, char** values) {
    const std::string name = count > 1 ? values[1] : "chandelier";
    const int voxels = count > 2 ? std::max(8, std::atoi(values[2])) : 128;
    const int repeats = count > 3 ? std::max(1, std::atoi(values[3])) : 3;
    const Scene scene = loadScene(name);
    const std::vector<Mesh> blockers = possibleBlockers(scene, scene.lights.at(0));
    const DistanceGrid grid = DistanceGrid::around(bounds(blockers), voxels);
    std::size_t triangles = 0;
    for (const Mesh& mesh : blockers) triangles += mesh.triangles.size();
    fmt::print("{}: {} meshes, {} triangles, {} x {} x {} voxels, {} threads\n", name,
               blockers.size(), triangles, grid.size.x, grid.size.y, grid.size.z, threadCount());
    using Clock = std::chrono::steady_clock;
    const fs::path folder =
        fs::temp_directory_path() / fmt::format("penumbra-benchmark-{:x}", std::random_device()());
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t cpu = std::clock();
        const auto start = Clock::now();
        Progress progress("distance field", grid.size.z);
        const DistanceField field = cachedDistanceField(folder, blockers, grid, &progress);
        const std::chrono::duration<double> wall = Clock::now() - start;
        const double processor = double(std::clock() - cpu) / double(CLOCKS_PER_SEC);
        const auto inside = std::count_if(field.values.begin(), field.values.end(),
                                          [](float d) { return d < 0.0f; });
        const auto again = Clock::now();
        cachedDistanceField(folder, blockers, grid);
        const std::chrono::duration<double> cached = Clock::now() - again;
        fmt::print(
            "{:.2f} s, {:.2f} s of processor time; from the cache {:.3f} s; {:.1f} % inside\n",
            wall.count(), processor, cached.count(),
            100.0 * double(inside) / double(field.values.size()));
        fs::remove_all(folder);
    }
}
