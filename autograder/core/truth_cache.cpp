#include "core/truth_cache.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <vector>

#include "core/error.h"
#include "core/frame_file.h"
#if defined(__linux__)
#include <link.h>
#endif

namespace penumbra {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSuffix = ".truth";

std::string hashOf(const TruthCache::Images& images) {
    TruthKey hash("images");
    for (const auto& [name, image] : images) hash.add(name), hash.add(image);
    return hash.text();
}

#if defined(__linux__)
std::vector<fs::path> loadedLibraries() {
    std::vector<fs::path> paths;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* list) {
            if (info->dlpi_name[0] == '/')  // neither the program itself nor the kernel's own
                static_cast<std::vector<fs::path>*>(list)->emplace_back(info->dlpi_name);
            return 0;
        },
        &paths);
    return paths;
}

// Embree chooses its instructions by these, and rounds accordingly.
std::string processor() {
    std::ifstream stream("/proc/cpuinfo");
    std::string text;
    for (std::string line; std::getline(stream, line) && !line.empty();)
        if (line.rfind("model name", 0) == 0 || line.rfind("flags", 0) == 0 ||
            line.rfind("Features", 0) == 0)
            text += line;
    return text;
}

bool addContent(TruthKey& hash, const fs::path& path) {
    std::error_code error;
    const auto size = fs::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream) return false;
    std::string bytes(size, '\0');
    stream.read(bytes.data(), std::streamsize(size));
    hash.add(bytes);
    return bool(stream);
}

std::string hashOfCode() {
    TruthKey hash("code");
    std::error_code error;
    bool known = addContent(hash, "/proc/self/exe");
    for (const fs::path& path : loadedLibraries()) {
        hash.add(path.string());
        if (path.filename().string().rfind("libpenumbra", 0) == 0) {
            known = addContent(hash, path) && known;
            continue;
        }
        hash.add(fs::file_size(path, error));
        known = known && !error;
        hash.add(fs::last_write_time(path, error).time_since_epoch().count());
        known = known && !error;
    }
    hash.add(processor());
    return known ? hash.text() : "";
}
#else
std::string hashOfCode() { return ""; }
#endif

}  // namespace

const std::string& codeHash() {
    static const std::string hash = hashOfCode();
    return hash;
}

TruthCache::TruthCache(fs::path folder, std::uintmax_t maximumBytes)
    : folder_(codeHash().empty() ? fs::path() : std::move(folder)), maximumBytes_(maximumBytes) {
    if (folder_.empty()) return;
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
        throw Error("cannot make the folder of truths", folder_.string(), "choose another one");
}

fs::path TruthCache::fileOf(const TruthKey& key) const {
    TruthKey withCode = key;
    withCode.add(codeHash());
    return folder_ / (withCode.text() + kSuffix);
}

std::optional<TruthCache::Images> TruthCache::load(const TruthKey& key) const {
    if (folder_.empty()) return {};
    const fs::path file = fileOf(key);
    try {
        FrameFile frame = loadFrameFile(file);
        if (frame.info["hash"] != hashOf(frame.images)) return {};
        std::error_code ignored;
        fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // used: kept longer
        return std::move(frame.images);
    } catch (const Error&) {
        return {};  // not there, or damaged
    }
}

void TruthCache::save(const TruthKey& key, const Images& images) const {
    if (folder_.empty()) return;
    static std::atomic<int> count = 0;
    const fs::path file = fileOf(key);
    const fs::path part =
        fs::path(file).concat("-" + std::to_string(getpid()) + "-" + std::to_string(++count));
    std::error_code ignored;
    try {
        saveFrameFile(part,
                      {.images = images, .milliseconds = {}, .info = {{"hash", hashOf(images)}}});
        fs::rename(part, file, ignored);
    } catch (const Error&) {
        fs::remove(part, ignored);  // a full disk: no truth is kept
    }
    removeOldest();
}

void TruthCache::removeOldest() const {
    struct Entry {
        fs::file_time_type time;
        std::uintmax_t bytes;
        fs::path path;
    };
    std::vector<Entry> entries;
    std::uintmax_t sum = 0;
    std::error_code error;  // another process may remove what is listed here
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
        if (entry.path().filename().string().find(kSuffix) == std::string::npos) continue;
        const auto bytes = entry.file_size(error);
        if (error) continue;
        entries.push_back({entry.last_write_time(error), bytes, entry.path()});
        sum += bytes;
    }
    if (sum <= maximumBytes_) return;
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.time < b.time; });
    for (const Entry& entry : entries) {
        if (sum <= maximumBytes_) return;
        fs::remove(entry.path, error);
        sum -= entry.bytes;
    }
}

}  // namespace penumbra
