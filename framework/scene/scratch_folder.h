// For tests: a folder of one process's own, gone at its end.
//
//   ScratchFolder scratch;
//   saveGlb(scratch / "a.glb", scene);
#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace penumbra {

class ScratchFolder {
public:
    ScratchFolder() {
        std::random_device random;  // tests run side by side
        path_ = std::filesystem::temp_directory_path() /
                ("penumbra-test-" + std::to_string(random()) + "-" + std::to_string(random()));
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

}  // namespace penumbra
