// A stack of folders in which a later one replaces files of the same name: how handout, solution,
// mistake and submission become one program.
//
//   Layers layers({root / "framework/shaders", handout, solution});
//   std::optional<std::filesystem::path> chunk = layers.find("depth_bias.glsl");
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace penumbra {

class Layers {
public:
    explicit Layers(std::vector<std::filesystem::path> folders = {});

    // The file of that name in the last folder that has one. `name` is a plain file name: a name
    // that leaves its folder ("../x") is never found.
    std::optional<std::filesystem::path> find(std::string_view name) const;

    const std::vector<std::filesystem::path>& folders() const { return folders_; }

private:
    std::vector<std::filesystem::path> folders_;
};

}  // namespace penumbra
