#include "field.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/blockers.h"
#include "scene/mesh_edges.h"
#include "truth/distance_field.h"

namespace penumbra {

namespace {

// Open meshes have no inside, and between voxels a look-up near a sheet does not come down to 0:
// half a voxel on an axis, sqrt(3) / 2 along a diagonal. So sheets get a thickness.
constexpr float kSkinVoxels = 0.5f;

void combine(std::vector<float>& values, const std::vector<float>& open, float skin) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::min(values[i], open[i] - skin);
}

}  // namespace

void BlockerField::prepare(const View& view, int voxels) {
    if (revision_ == view.revision && voxels_ == voxels) return;
    notes_.clear();
    skin_ = 0;
    std::vector<Mesh> blockers = possibleBlockers(view.scene, view.light);
    std::vector<float> values;
    if (blockers.empty()) {
        // One voxel as far from everything as the scene is wide: nothing blocks.
        const Box box = bounds(view.scene);
        const float size = glm::length(box.upper - box.lower);
        grid_ = {.lower = box.lower, .cell = size, .size = glm::ivec3(1)};
        values = {size};
    } else {
        grid_ = DistanceGrid::around(bounds(blockers), voxels);
        const auto open = std::stable_partition(blockers.begin(), blockers.end(),
                                                [](const Mesh& m) { return closed(meshEdges(m)); });
        const std::span<const Mesh> closedOnes(blockers.begin(), open);
        const std::span<const Mesh> openOnes(open, blockers.end());
        Progress progress("distance field",
                          grid_.size.z * (closedOnes.empty() || openOnes.empty() ? 1 : 2));
        const auto build = [&](std::span<const Mesh> meshes) {
            return distanceField(meshes, grid_, &progress).values;
        };
        values = closedOnes.empty() ? std::vector<float>(grid_.count(), 1e30f) : build(closedOnes);
        if (!openOnes.empty()) {
            skin_ = kSkinVoxels * grid_.cell;
            combine(values, build(openOnes), skin_);
        }
        for (const Mesh& mesh : openOnes)
            notes_.push_back(fmt::format(
                "mesh {} is open: it has no inside, and blocks as a sheet {} voxel thick",
                mesh.name, 2 * kSkinVoxels));
    }
    texture_ = VolumeTexture({.size = grid_.size, .format = GL_R32F, .label = "distance field"});
    texture_.upload(values);
    revision_ = view.revision, voxels_ = voxels;
}

FieldBlock fieldBlock(const Settings& s, const BlockerField& field) {
    const DistanceGrid& grid = field.grid();
    const glm::vec3 upper = grid.upper();
    return {.lower = grid.lower,
            .cell = grid.cell,
            .upper = upper,
            .normalOffset = s["normal_offset"] * grid.cell + field.skin(),
            .k = s["k"],
            .stepCap = s["step_cap"],
            .smallestStep = s["smallest_step"] * grid.cell,
            .maxSteps = s.index("max_steps"),
            .sliceY = grid.lower.y + s["slice"] * (upper.y - grid.lower.y)};
}

std::vector<std::string> chunksFor(const Settings& s) {
    const std::string method = s.chosen("method");
    const bool circles = method == "closest_approach";
    return {"receiver_visibility.glsl", "volume.glsl",
            "method_" + (circles ? "lecture" : method) + ".glsl",
            circles ? "approach_circles.glsl" : "approach_plain.glsl",
            s.on("horizon") ? "horizon_on.glsl" : "horizon_off.glsl"};
}

}  // namespace penumbra
