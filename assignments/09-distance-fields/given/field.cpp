#include "field.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/cache_folder.h"
#include "scene/blockers.h"
#include "scene/mesh_edges.h"
#include "truth/distance_cache.h"

namespace penumbra {

namespace {

// Open meshes have no inside, and on a sheet a look-up between voxels is not 0 but the mean of the
// eight corners' heights over it: at most the root of their mean square, which is that of half a
// voxel each way, however the sheet lies. So a skin of less than half a voxel lets light through,
// and this one holds wherever the sheet is wide. Towards its outline the skin gets thin: blockers
// grow by it there, and leaves of two voxels are all outline.
constexpr double kSkinVoxels = 0.55, kOutlineSkinVoxels = 0.3;

constexpr float kFar = 1e15f;  // of nothing; its square is finite

// The skin where the outline is so far off; all in voxels.
double skinVoxels(double inwards) {
    return std::lerp(kOutlineSkinVoxels, kSkinVoxels, std::clamp(inwards - 1.0, 0.0, 1.0));
}

// Edges of one triangle, each a triangle without area.
Mesh outline(std::span<const Mesh> meshes) {
    Mesh result;
    for (const Mesh& mesh : meshes)
        for (const MeshEdges edges = meshEdges(mesh); const MeshEdge& edge : edges.edges) {
            if (edge.sideCount != 1) continue;
            const auto i = std::uint32_t(result.positions.size());
            result.positions.push_back(mesh.positions[edge.from]);
            result.positions.push_back(mesh.positions[edge.to]);
            result.triangles.push_back({i, i + 1, i + 1});
        }
    return result;
}

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
    const Mesh borders = outline(openMeshes);
    const std::span<const Mesh> outlines(&borders, borders.triangles.empty() ? 0 : 1);
    Progress progress(
        "distance field",
        long(grid_.size.z) * (!closedMeshes.empty() + !openMeshes.empty() + !outlines.empty()));
    const auto field = [&](std::span<const Mesh> meshes) {
        return meshes.empty() ? std::vector<float>(grid_.count(), kFar)
                              : cachedDistanceField(cacheFolder(), meshes, grid_, &progress).values;
    };
    std::vector<float> values = field(closedMeshes);
    if (!openMeshes.empty()) {
        skin_ = float(kOutlineSkinVoxels) * grid_.cell;
        const float most = float(kSkinVoxels) * grid_.cell;
        box_.lower -= most, box_.upper += most;
        const std::vector<float> sheets = field(openMeshes), border = field(outlines);
        const double cell = double(grid_.cell);
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            const double d = double(sheets[i]), toBorder = double(border[i]);
            const double inwards = std::sqrt(std::max(toBorder * toBorder - d * d, 0.0));
            values[i] = std::min(values[i], float(d - skinVoxels(inwards / cell) * cell));
        }
    }
    notes_.push_back(fmt::format("field of {} x {} x {} voxels, {:.2g} wide", grid_.size.x,
                                 grid_.size.y, grid_.size.z, grid_.cell));
    for (const Mesh& mesh : openMeshes)
        notes_.push_back(fmt::format(
            "mesh {} is open: it has no inside, and blocks as a sheet, up to {:.2g} thick",
            mesh.name, 2.0 * kSkinVoxels * double(grid_.cell)));
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
