#include "scene/gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>

#include "core/error.h"
#include "scene/gallery_scenes.h"
#include "scene/gltf.h"

namespace penumbra {

namespace {

struct BuiltIn {
    const char* name;
    double number;  // where the name comes without @number
    double maximum;
    bool whole;
    const char* meaning;
    std::function<Scene(double)> make;
};

constexpr double kLargestSeed = 4294967295.0;

BuiltIn seeded(const char* name, Scene (*make)(std::uint64_t)) {
    return {
        name, 1.0, kLargestSeed, true, "a whole seed from 0 to 4294967295", [make](double number) {
            return make(std::uint64_t(number));
        }};
}

const std::vector<BuiltIn>& builtIns() {
    static const std::vector<BuiltIn> scenes = {
        seeded("boxes", boxesScene),
        seeded("fence", fenceScene),
        seeded("foliage", foliageScene),
        seeded("stairs", stairsScene),
        seeded("halfplane", halfPlaneScene),
        seeded("polygon", polygonScene),
        {"tilted", 80.0, 89.5, false, "degrees from 0 to 89.5", tiltedScene},
        {"board", 30.0, 80.0, false, "degrees from 0 to 80", boardScene},
        seeded("hollow", hollowScene),
        seeded("mast", mastScene),
        seeded("sun", sunScene),
        seeded("eye_inside", eyeInsideScene),
        seeded("near_cut", nearCutScene),
        {"nested", 256.0, 1000.0, true, "a whole number of sheets from 0 to 1000", nestedScene},
        seeded("lamp", lampScene),
        seeded("shut_lamp", shutLampScene),
        seeded("open_mesh", openMeshScene),
        seeded("courtyard", courtyardScene),
    };
    return scenes;
}

double parsedNumber(const BuiltIn& scene, const std::string& wholeName, const std::string& text) {
    double value = -1.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool fits = !scene.whole || value == std::floor(value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0) ||
        value > scene.maximum || !fits)
        throw Error("bad number in scene name", wholeName,
                    fmt::format("after {}@ write {}", scene.name, scene.meaning));
    return value;
}

bool isPath(const std::string& name) {
    const auto extension = std::filesystem::path(name).extension();
    return name.find_first_of("/\\") != std::string::npos || extension == ".glb" ||
           extension == ".gltf";
}

std::filesystem::path modelsFolder() { return repositoryRoot() / "models"; }

// A plain file name without its ending, so that "..", for one, is no model.
std::filesystem::path modelPath(const std::string& name) {
    return modelsFolder() / (name + ".glb");
}

[[noreturn]] void throwUnknown(const std::string& name) {
    const auto models = installedModelNames();
    throw Error(
        "unknown scene", name.empty() ? "(no name)" : name,
        fmt::format("built in: {}; models: {}; or a path to a .glb or .gltf",
                    fmt::join(builtInSceneNames(), " "),
                    models.empty() ? "none installed" : fmt::format("{}", fmt::join(models, " "))));
}

}  // namespace

std::filesystem::path repositoryRoot() {
    const char* fromEnvironment = std::getenv("PENUMBRA_ROOT");
    return fromEnvironment && *fromEnvironment ? fromEnvironment : PENUMBRA_ROOT;
}

std::vector<std::string> builtInSceneNames() {
    std::vector<std::string> names;
    for (const BuiltIn& scene : builtIns()) names.emplace_back(scene.name);
    return names;
}

std::vector<std::string> installedModelNames() {
    std::vector<std::string> names;
    std::error_code none;  // no folder: no models
    for (const auto& entry : std::filesystem::directory_iterator(modelsFolder(), none))
        if (entry.path().extension() == ".glb") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Scene loadScene(const std::string& nameOrPath) {
    if (isPath(nameOrPath)) return loadGltf(nameOrPath);
    const std::size_t at = nameOrPath.find('@');
    const std::string name = nameOrPath.substr(0, at);
    std::optional<std::string> number;
    if (at != std::string::npos) number = nameOrPath.substr(at + 1);

    for (const BuiltIn& builtIn : builtIns()) {
        if (name != builtIn.name) continue;
        Scene scene =
            builtIn.make(number ? parsedNumber(builtIn, nameOrPath, *number) : builtIn.number);
        scene.name = nameOrPath;
        return scene;
    }
    std::error_code none;
    if (!name.empty() && std::filesystem::exists(modelPath(name), none)) {
        if (number) throw Error("a model takes no number", nameOrPath, "write " + name);
        Scene scene = loadGltf(modelPath(name));
        scene.name = name;
        return scene;
    }
    throwUnknown(nameOrPath);
}

}  // namespace penumbra
