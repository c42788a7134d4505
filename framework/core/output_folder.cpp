#include "core/output_folder.h"

#include <chrono>
#include <fstream>

#include "core/error.h"

namespace penumbra {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path target) : target_(std::move(target)) {
    const auto stamp = std::chrono::steady_clock::now().time_since_epoch().count();
    part_ = target_ / (".part-" + std::to_string(stamp));
    std::error_code error;
    fs::create_directories(part_, error);
    if (error) throw Error("cannot make the output folder", target_.string(), error.message());
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    fs::remove_all(part_, ignored);
    if (fs::is_empty(target_, ignored)) fs::remove(target_, ignored);
}

void OutputFolder::commit() {
    for (const auto& entry : fs::directory_iterator(part_)) {
        const fs::path place = target_ / entry.path().filename();
        std::error_code error;
        if (entry.is_directory())
            fs::remove_all(place, error);  // a folder does not replace a full one
        fs::rename(entry.path(), place, error);
        if (error) throw Error("cannot move a result into place", place.string(), error.message());
    }
}

void writeText(const fs::path& path, const std::string& text) {
    const fs::path part = fs::path(path).concat(".part");
    std::ofstream file(part, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw Error("cannot write", path.string(), "check that the folder is writable");
    fs::rename(part, path);
}

}  // namespace penumbra
