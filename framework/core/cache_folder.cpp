#include "core/cache_folder.h"

#include <cstdlib>

namespace penumbra {

std::filesystem::path cacheFolder() {
    const auto folder = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::filesystem::path(value ? value : "");
    };
    if (const auto ours = folder("PENUMBRA_CACHE"); !ours.empty()) return ours;
    for (const char* variable : {"XDG_CACHE_HOME", "LOCALAPPDATA"})
        if (const auto base = folder(variable); base.is_absolute()) return base / "penumbra";
    if (const auto home = folder("HOME"); home.is_absolute()) return home / ".cache" / "penumbra";
    return std::filesystem::temp_directory_path() / "penumbra";
}

}  // namespace penumbra
