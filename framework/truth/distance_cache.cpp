#include "truth/distance_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace penumbra {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kVersion = 1;  // grows when the file, or what fields hold, changes
constexpr std::uint64_t kMagic = 0x31666473'6d756e65ull;

// 64 bits that guard against accidents, not against forgers: words mixed in one after another by
// SplitMix64's finalizer [Steele, Lea, Flood 2014].
class Hash {
public:
    void add(std::uint64_t word) {
        std::uint64_t z = (value_ ^ word) + 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        value_ = z ^ (z >> 31);
    }
    template <class T>
    void add(std::span<const T> values) {
        static_assert(sizeof(T) % 4 == 0 && std::is_trivially_copyable_v<T>);
        add(values.size());
        const std::size_t bytes = values.size_bytes();
        const auto* from = reinterpret_cast<const char*>(values.data());
        for (std::size_t i = 0; i < bytes; i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, from + i, std::min<std::size_t>(8, bytes - i));
            add(word);
        }
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0;
};

struct Header {
    std::uint64_t magic = kMagic;  // reads differently in another byte order
    std::uint64_t key = 0;         // of what the values depend on
    std::uint64_t checksum = 0;    // of the values

    bool operator==(const Header&) const = default;
};

std::uint64_t keyOf(std::span<const Mesh> meshes, const DistanceGrid& grid) {
    Hash hash;
    hash.add(kVersion);
    const std::uint32_t words[] = {std::bit_cast<std::uint32_t>(grid.lower.x),
                                   std::bit_cast<std::uint32_t>(grid.lower.y),
                                   std::bit_cast<std::uint32_t>(grid.lower.z),
                                   std::bit_cast<std::uint32_t>(grid.cell),
                                   std::uint32_t(grid.size.x),
                                   std::uint32_t(grid.size.y),
                                   std::uint32_t(grid.size.z)};
    hash.add(std::span<const std::uint32_t>(words));
    for (const Mesh& mesh : meshes) {
        hash.add(std::span<const glm::vec3>(mesh.positions));
        hash.add(std::span<const glm::uvec3>(mesh.triangles));
    }
    return hash.value();
}

Header headerOf(std::uint64_t key, const std::vector<float>& values) {
    Hash hash;
    hash.add(std::span<const float>(values));
    return {.key = key, .checksum = hash.value()};
}

std::optional<DistanceField> read(const fs::path& path, std::uint64_t key,
                                  const DistanceGrid& grid) {
    std::error_code none;
    const std::size_t bytes = grid.count() * sizeof(float);
    if (fs::file_size(path, none) != sizeof(Header) + bytes) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    Header header;
    DistanceField field{grid, std::vector<float>(grid.count())};
    file.read(reinterpret_cast<char*>(&header), sizeof header);
    file.read(reinterpret_cast<char*>(field.values.data()), std::streamsize(bytes));
    if (!file || header != headerOf(key, field.values)) return std::nullopt;
    fs::last_write_time(path, fs::file_time_type::clock::now(), none);  // used: stays longer
    return field;
}

void removeOldest(const fs::path& folder, std::uintmax_t bytesKept) {
    struct File {
        fs::file_time_type used;
        std::uintmax_t bytes;
        fs::path path;
    };
    std::vector<File> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        std::error_code gone;  // another program cleans up, too
        const File file{entry.last_write_time(gone), entry.file_size(gone), entry.path()};
        if (!gone) files.push_back(file);
    }
    std::sort(files.begin(), files.end(),
              [](const File& a, const File& b) { return a.used > b.used; });
    std::uintmax_t sum = 0;
    for (const File& file : files)
        if ((sum += file.bytes) > bytesKept) fs::remove(file.path, none);
}

bool write(const fs::path& path, const Header& header, const std::vector<float>& values) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    const fs::path part = fs::path(path).concat(fmt::format(".part-{:x}", std::random_device()()));
    std::ofstream file(part, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    file.write(reinterpret_cast<const char*>(values.data()),
               std::streamsize(values.size() * sizeof(float)));
    file.close();
    if (file) fs::rename(part, path, error);
    const bool written = file && !error;
    if (!written) fs::remove(part, error);
    return written;
}

}  // namespace

DistanceField cachedDistanceField(const fs::path& folder, std::span<const Mesh> meshes,
                                  const DistanceGrid& grid, Progress* progress,
                                  std::uintmax_t bytesKept) {
    const std::uint64_t key = keyOf(meshes, grid);
    const fs::path place = folder / "distance-fields";
    const fs::path path = place / fmt::format("{:016x}", key);
    if (auto kept = read(path, key, grid)) {
        if (progress) progress->advance(grid.size.z);
        return std::move(*kept);
    }
    DistanceField field = distanceField(meshes, grid, progress);
    if (field.values.empty()) return field;  // cancelled
    if (!write(path, headerOf(key, field.values), field.values))
        fmt::print(stderr, "cannot keep the distance field in {}: it is made anew each time\n",
                   place.string());
    removeOldest(place, bytesKept);
    return field;
}

}  // namespace penumbra
