// What your C++ returned, as images: for the grader, and for you.
#include "value_rows.h"
#include "volume_counter.h"

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

}  // namespace

void VolumeCounter::handOverLists(const View& view, Frame& frame) {
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
