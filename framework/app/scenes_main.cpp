// Names of all scenes that --scene takes: `penumbra-scenes [--built-in]`.
#include <fmt/format.h>

#include <string_view>

#include "scene/gallery.h"

int main(int argc, char** argv) {
    using namespace penumbra;
    const bool bare = argc > 1 && std::string_view(argv[1]) == "--built-in";
    if (!bare) fmt::print("scenes\n    built in: {}\n", fmt::join(builtInSceneNames(), ", "));
    if (bare)
        for (const auto& name : builtInSceneNames()) fmt::print("{}\n", name);
    else if (const auto models = installedModelNames(); !models.empty())
        fmt::print("    models:   {}\n", fmt::join(models, ", "));
    else
        fmt::print("    models:   none yet; ./course demo installs them\n");
}
