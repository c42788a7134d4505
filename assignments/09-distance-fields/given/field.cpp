#include "field.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/cache_folder.h"
#include "scene/blockers.h"
#include "scene/mesh_edges.h"
#include "truth/distance_cache.h"

namespace penumbra {

using namespace std::chrono_literals;

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

// One voxel that is as far from everything as the scene is wide: nothing blocks.
BlockerField::Field emptyField(const Scene& scene) {
    const Box box = bounds(scene);
    const float far = glm::length(box.upper - box.lower);
    return {.grid = {.lower = box.lower, .cell = far, .size = glm::ivec3(1)},
            .box = box,
            .values = {far},
            .notes = {}};
}

BlockerField::Field fieldOf(std::span<const Mesh> closedMeshes, std::span<const Mesh> openMeshes,
                            const Mesh& borders, BlockerField::Field result, Progress& progress) {
    const auto field = [&](std::span<const Mesh> meshes) {
        return meshes.empty()
                   ? std::vector<float>(result.grid.count(), kFar)
                   : cachedDistanceField(cacheFolder(), meshes, result.grid, &progress).values;
    };
    result.values = field(closedMeshes);
    if (!openMeshes.empty()) {
        const double cell = double(result.grid.cell);
        result.skin = float(kOutlineSkinVoxels * cell);
        const float most = float(kSkinVoxels * cell);
        result.box.lower -= most, result.box.upper += most;
        const std::span<const Mesh> outlines(&borders, borders.triangles.empty() ? 0 : 1);
        const std::vector<float> sheets = field(openMeshes), border = field(outlines);
        if (progress.cancelled) return {};
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            const double d = double(sheets[i]), toBorder = double(border[i]);
            const double inwards = std::sqrt(std::max(toBorder * toBorder - d * d, 0.0));
            result.values[i] =
                std::min(result.values[i], float(d - skinVoxels(inwards / cell) * cell));
        }
    }
    const glm::ivec3 size = result.grid.size;
    result.notes.push_back(fmt::format("field of {} x {} x {} voxels, {:.2g} wide", size.x, size.y,
                                       size.z, result.grid.cell));
    for (const Mesh& mesh : openMeshes)
        result.notes.push_back(fmt::format(
            "mesh {} is open: it has no inside, and blocks as a sheet, up to {:.2g} thick",
            mesh.name, 2.0 * kSkinVoxels * double(result.grid.cell)));
    return result;
}

}  // namespace

BlockerField::~BlockerField() { cancel(); }

void BlockerField::cancel() {
    if (!work_) return;
    work_->cancelled = true;
    made_.wait();
    work_.reset();
}

void BlockerField::prepare(const View& view, int voxels) {
    const bool sameScene = revision_ == view.revision && voxels_ == voxels;
    auto patience = 0ms;
    if (!sameScene || light_ != view.light) {
        std::vector<Mesh> blockers = possibleBlockers(view.scene, view.light);
        std::vector<std::string> names;
        for (const Mesh& mesh : blockers) names.push_back(mesh.name);
        const bool same = sameScene && names == blockers_;
        if (!same) {
            revision_ = -1;  // if something throws, the next frame tries again
            cancel();
            blockers_ = std::move(names), voxels_ = voxels;
            take(emptyField(view.scene));
            if (!blockers.empty()) start(std::move(blockers), view.interactive);
            patience = 100ms;  // most fields come from the cache: no picture without shadow first
        }
        revision_ = view.revision, light_ = view.light;
    }
    if (!work_) return;
    if (view.interactive && made_.wait_for(patience) != std::future_status::ready) return;
    work_.reset();
    try {
        take(made_.get());
    } catch (...) {
        revision_ = -1;
        throw;
    }
}

void BlockerField::start(std::vector<Mesh> blockers, bool interactive) {
    Field field;
    field.box = bounds(blockers);
    field.grid = DistanceGrid::around(field.box, voxels_);
    const auto open = std::stable_partition(
        blockers.begin(), blockers.end(), [](const Mesh& mesh) { return closed(meshEdges(mesh)); });
    std::vector<Mesh> openMeshes(std::make_move_iterator(open),
                                 std::make_move_iterator(blockers.end()));
    blockers.erase(open, blockers.end());
    Mesh borders = outline(openMeshes);
    const int fields = !blockers.empty() + !openMeshes.empty() + !borders.triangles.empty();
    const long steps = long(field.grid.size.z) * fields;
    work_ = std::make_shared<Progress>("distance field", steps, interactive);
    made_ =
        std::async(std::launch::async,
                   [closedMeshes = std::move(blockers), openMeshes = std::move(openMeshes),
                    borders = std::move(borders), field = std::move(field), steps, work = work_] {
                       try {
                           return fieldOf(closedMeshes, openMeshes, borders, field, *work);
                       } catch (...) {
                           work->advance(steps);  // the window asks for the frame, and hears of it
                           throw;
                       }
                   });
}

void BlockerField::take(Field field) {
    texture_ =
        VolumeTexture({.size = field.grid.size, .format = GL_R32F, .label = "distance field"});
    texture_.upload(field.values);
    field.values = {};
    field_ = std::move(field);
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
