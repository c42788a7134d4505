#include "soft_shadow.h"

namespace penumbra {

SoftShadowBlock softShadowBlock(const Settings& settings, int mapSize) {
    return {.filterWidthUv = glm::vec2(2 * settings["pcf_radius"] / float(mapSize)),
            .searchSamples = settings.index("search_samples"),
            .filterSamples = settings.index("filter_samples"),
            .minTexelUv = 1.0f};
}

std::vector<std::string> chunksFor(const Settings& s) {
    return {"receiver_visibility.glsl",
            "method_" + s.chosen("method") + ".glsl",
            "kernel_" + s.chosen("kernel") + ".glsl",
            s.on("receiver_plane") ? "blocks_by_plane.glsl" : "blocks_by_depth.glsl",
            s.on("horizon") ? "horizon_on.glsl" : "horizon_off.glsl",
            s.on("pyramid") ? "window_narrowed.glsl" : "window_full.glsl"};
}

}  // namespace penumbra
