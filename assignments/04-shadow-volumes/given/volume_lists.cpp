// What your C++ returned, as images: for the grader, and for you.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "value_rows.h"
#include "volume_pass.h"

namespace penumbra {

namespace {

void append(std::vector<float>& values, const std::vector<int>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

// Mesh, vertex, 1 for its twin, kind.
void append(std::vector<float>& corners, const std::vector<glm::uvec3>& triangles, std::size_t mesh,
            std::size_t vertices, float kind) {
    for (const glm::uvec3 t : triangles)
        for (int k = 0; k < 3; ++k) {
            const bool far = t[k] >= vertices;
            const auto vertex = float(far ? t[k] - vertices : t[k]);
            corners.insert(corners.end(), {float(mesh), vertex, float(far), kind});
        }
}

std::string firstFew(const std::vector<std::string>& names) {
    const auto few = std::span(names).first(std::min<std::size_t>(names.size(), 3));
    return fmt::format("{}{}", fmt::join(few, ", "), names.size() > few.size() ? ", …" : "");
}

}  // namespace

void VolumePass::addNotes(const View& view, Frame& frame) const {
    std::vector<std::string> open, masked;
    std::string why;
    for (const LightVolumes::Part part : parts(view, view.light)) {
        const Mesh& mesh = view.scene.meshes[part.mesh];
        const std::string name = mesh.name.empty() ? std::to_string(part.mesh) : mesh.name;
        const MeshReport& report = volumes_->casters()[part.mesh].report;
        if (!report.closed()) {
            if (open.empty()) why = report.text();
            open.push_back(name);
        }
        if (view.scene.materials[std::size_t(mesh.material)].alphaCutoff > 0)
            masked.push_back(name);
    }
    if (!open.empty())
        frame.note(
            fmt::format("{} of {} meshes ({}) take all their triangles for a volume; {} is {}",
                        open.size(), view.scene.meshes.size(), firstFew(open), open.front(), why));
    if (!masked.empty())
        frame.note(fmt::format("alpha masks are unknown to volumes ({}): holes cast shadow, too",
                               firstFew(masked)));
}

void VolumePass::handOverLists(const View& view, Frame& frame) {
    const char* const names[] = {"facing", "weights", "edge_sums", "mesh_kinds",
                                 "volume_triangles"};
    if (std::none_of(std::begin(names), std::end(names),
                     [&](const char* name) { return frame.wants(name); }))
        return;
    const glm::vec4 light = view.light.position();
    LightVolumes& volumes = volumesOf(view, 0, view.light);
    std::vector<float> facing, weights, sums, kinds, corners;
    for (std::size_t i = 0; i < view.scene.meshes.size(); ++i) {
        const Mesh& mesh = view.scene.meshes[i];
        const MeshVolume& volume = volumes.ofMesh(i);
        if (frame.wants("facing")) append(facing, facingTriangles(mesh, light));
        append(weights, volume.weights);
        append(sums, volume.sums);
        kinds.push_back(float(volume.allTriangles));
        append(corners, volume.sides, i, mesh.positions.size(), 0);
        append(corners, volume.caps.outward, i, mesh.positions.size(), 1);
        append(corners, volume.caps.inward, i, mesh.positions.size(), 2);
    }
    if (frame.wants("facing")) frame.output("facing", valueRows(facing));
    frame.output("weights", valueRows(weights));
    frame.output("edge_sums", valueRows(sums));
    frame.output("mesh_kinds", valueRows(kinds));
    frame.output("volume_triangles", valueRows(corners, 4));
}

}  // namespace penumbra
