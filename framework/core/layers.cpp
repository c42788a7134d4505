#include "core/layers.h"

#include <algorithm>

namespace penumbra {

namespace fs = std::filesystem;

Layers::Layers(std::vector<fs::path> folders) : folders_(std::move(folders)) {}

std::optional<fs::path> Layers::find(std::string_view name) const {
    const fs::path file(name);
    if (name.empty() || file.is_absolute() ||
        std::any_of(file.begin(), file.end(), [](const fs::path& part) { return part == ".."; }))
        return std::nullopt;
    for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder) {
        std::error_code ignored;
        if (fs::is_regular_file(*folder / file, ignored)) return *folder / file;
    }
    return std::nullopt;
}

}  // namespace penumbra
