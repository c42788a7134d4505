#include "field.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/cache_folder.h"
#include "scene/blockers.h"
#include "scene/mesh_edges.h"
#include "truth/distance_cache.h"

namespace penumbra {

namespace {

// Open meshes have no inside, and between voxels a look-up near a sheet does not come down to 0:
// at worst to half a voxel. So sheets get a thickness: with less, light comes through; with more,
// they grow.
constexpr float kSkinVoxels = 0.3f;

}  // namespace

void BlockerField::prepare(const View& view, int voxels) {
    const bool sameScene = revision_ == view.revision && voxels_ == voxels;
    if (sameScene && light_ == view.light) return;
    std::vector<Mesh> blockers = possibleBlockers(view.scene, view.light);
    std::vector<std::string> names;
    for (const Mesh& mesh : blockers) names.push_back(mesh.name);
    const bool same = sameScene && names == blockers_;
    revision_ = view.revision, light_ = view.light, voxels_ = voxels, blockers_ = std::move(names);
    if (same) return;
    notes_.clear();
    skin_ = 0;
    if (blockers.empty()) return makeEmpty(view.scene);
    box_ = bounds(blockers);
    grid_ = DistanceGrid::around(box_, voxels);
    const auto open = std::stable_partition(
        blockers.begin(), blockers.end(), [](const Mesh& mesh) { return closed(meshEdges(mesh)); });
    make({blockers.begin(), open}, {open, blockers.end()});
}

void BlockerField::make(std::span<const Mesh> closedMeshes, std::span<const Mesh> openMeshes) {
    Progress progress("distance field",
                      long(grid_.size.z) * (!closedMeshes.empty() + !openMeshes.empty()));
    const auto field = [&](std::span<const Mesh> meshes) {
        return cachedDistanceField(cacheFolder(), meshes, grid_, &progress).values;
    };
    std::vector<float> values;
    if (!closedMeshes.empty()) values = field(closedMeshes);
    if (!openMeshes.empty()) {
        skin_ = kSkinVoxels * grid_.cell;
        box_.lower -= skin_, box_.upper += skin_;
        std::vector<float> sheets = field(openMeshes);
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            sheets[i] -= skin_;
            if (!values.empty()) sheets[i] = std::min(sheets[i], values[i]);
        }
        values = std::move(sheets);
    }
    notes_.push_back(fmt::format("field of {} x {} x {} voxels, {:.2g} wide", grid_.size.x,
                                 grid_.size.y, grid_.size.z, grid_.cell));
    for (const Mesh& mesh : openMeshes)
        notes_.push_back(fmt::format(
            "mesh {} is open: it has no inside, and blocks as a sheet, one voxel ({:.2g}) thick",
            mesh.name, grid_.cell));
    texture_ = VolumeTexture({.size = grid_.size, .format = GL_R32F, .label = "distance field"});
    texture_.upload(values);
}

// One voxel that is as far from everything as the scene is wide: nothing blocks.
void BlockerField::makeEmpty(const Scene& scene) {
    box_ = bounds(scene);
    grid_ = {
        .lower = box_.lower, .cell = glm::length(box_.upper - box_.lower), .size = glm::ivec3(1)};
    texture_ = VolumeTexture({.size = grid_.size, .format = GL_R32F, .label = "distance field"});
    texture_.upload(std::vector<float>{grid_.cell});
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
            .blockersLower = field.box().lower,
            .sliceY = grid.lower.y + s["slice"] * (upper.y - grid.lower.y),
            .blockersUpper = field.box().upper};
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
