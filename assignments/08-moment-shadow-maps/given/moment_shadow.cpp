#include "moment_shadow.h"

namespace penumbra {

MomentShadowBlock momentShadowBlock(const Settings& settings, int mapSize) {
    return {.filterWidthUv = glm::vec2(2 * settings["filter_radius"] / float(mapSize)),
            .momentBias = std::stof(settings.chosen("moment_bias")),
            .refinements = settings.index("refinements"),
            .cells = settings.index("cells"),
            .unitsPerInteger = 1};
}

std::vector<std::string> chunksFor(const Settings& s) {
    return {"receiver_visibility.glsl",
            "method_" + s.chosen("method") + ".glsl",
            "filter_" + s.chosen("filter") + ".glsl",
            "storage_" + s.chosen("storage") + ".glsl",
            "prefilter_" + s.chosen("prefilter") + ".glsl",
            s.on("receiver_plane") ? "compared_by_plane.glsl" : "compared_by_depth.glsl",
            s.on("horizon") ? "horizon_on.glsl" : "horizon_off.glsl"};
}

}  // namespace penumbra
