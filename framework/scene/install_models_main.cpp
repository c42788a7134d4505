// penumbra-install-models ARCHIVES OUT: converts the models that models.json lists from unpacked
// sweethome3d-furniture archives (a folder ARCHIVES/<archive> each) to OUT/<name>.glb, and writes
// OUT/ATTRIBUTION.md. install_models.sh calls it and moves the result into place.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "scene/gallery.h"
#include "scene/gltf.h"
#include "scene/obj_import.h"
#include "scene/stage.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace penumbra {
namespace {

struct Credit {
    std::string title;
    std::string creator;
};

// The archive's catalogue is a Java properties file: "model#12=/folder/x.obj", "creator#12=Name".
Credit creditOf(const fs::path& archive, const std::string& obj) {
    std::ifstream file(archive / "PluginFurnitureCatalog.properties");
    std::map<std::string, Credit> credits;
    std::string line, number;
    while (std::getline(file, line)) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        const std::size_t hash = line.find('#'), equals = line.find('=');
        if (hash == std::string::npos || equals == std::string::npos || hash > equals) continue;
        const std::string key = line.substr(0, hash), value = line.substr(equals + 1);
        const std::string entry = line.substr(hash + 1, equals - hash - 1);
        if (key == "name") credits[entry].title = value;
        if (key == "creator") credits[entry].creator = value;
        if (key == "model" && value == "/" + obj) number = entry;
    }
    if (number.empty() || credits[number].creator.empty())
        throw Error("model has no creator in its catalogue", (archive / obj).string(),
                    "models are installed with attribution only");
    return credits[number];
}

std::string install(const json& model, const json& licence, const fs::path& archives,
                    const fs::path& out) {
    const std::string name = model.at("name"), archive = model.at("archive"), obj = model.at("obj");
    const Credit credit = creditOf(archives / archive, obj);
    Scene scene = importObj(archives / archive / obj);
    scene.name = name;
    stageModel(scene, {.size = model.value("size", 3.0f),
                       .lift = model.value("lift", 0.0f),
                       .turnDegrees = model.value("turn", 0.0f)});
    const fs::path path = out / (name + ".glb");
    saveGlb(path, scene);
    const Scene loaded = loadGltf(path);  // a model that does not load back must not be installed
    fmt::print("{:18} {:7} triangles  {:2} textures  {:5.1f} MB\n", name, triangleCount(loaded),
               loaded.textures.size(), double(fs::file_size(path)) / 1e6);
    std::fflush(stdout);
    return fmt::format("| {} | {} | {} | [{}]({}) | {}.sh3f, {} |\n", name, credit.title,
                       credit.creator, licence.at("licence").get<std::string>(),
                       licence.at("url").get<std::string>(), archive, obj);
}

void installAll(const fs::path& archives, const fs::path& out) {
    const fs::path manifest = repositoryRoot() / "framework/scene/models.json";
    std::ifstream file(manifest);
    if (!file) throw Error("no such file", manifest.string(), "run this in the repository");
    const json list = json::parse(file);
    fs::create_directories(out);
    std::string text =
        "# Models\n\nFrom the Debian package sweethome3d-furniture 1.8. Changed: converted to "
        "glTF,\n"
        "scaled, placed on a ground with a light and a camera; clear glass left out.\n\n"
        "| model | title | author | licence | source |\n| --- | --- | --- | --- | --- |\n";
    for (const json& model : list.at("models"))
        text += install(model, list.at("archives").at(model.at("archive").get<std::string>()),
                        archives, out);
    std::ofstream(out / "ATTRIBUTION.md") << text;
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: penumbra-install-models ARCHIVES OUT\n");
        return 2;
    }
    try {
        penumbra::installAll(argv[1], argv[2]);
    } catch (const std::exception& e) {
        fmt::print(stderr, "penumbra-install-models: {}\n", e.what());
        return 2;
    }
    return 0;
}
