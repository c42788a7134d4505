#include "truth/inside_slices.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scene/mesh_edges.h"

namespace penumbra {

namespace {

// Where a row's winding number changes: at this voxel and all after it.
struct Crossing {
    int row, voxel, sign;
};

// The first voxel along an axis whose centre lies at or beyond `place`, or `size`.
int firstFrom(const DistanceGrid& grid, int axis, double place) {
    const double steps = (place - double(grid.lower[axis])) / double(grid.cell);
    int i = int(std::clamp(std::floor(steps), 0.0, double(grid.size[axis])));
    const auto center = [&](int voxel) { return grid.center(glm::ivec3(voxel))[axis]; };
    while (i > 0 && center(i - 1) >= place) --i;
    while (i < grid.size[axis] && center(i) < place) ++i;
    return i;
}

glm::dvec2 cut(glm::vec3 from, glm::vec3 to, double z) {
    if (std::tie(to.x, to.y, to.z) < std::tie(from.x, from.y, from.z)) std::swap(from, to);
    const glm::dvec3 p(from), q(to);
    return glm::dvec2(p) + (z - p.z) / (q.z - p.z) * (glm::dvec2(q) - glm::dvec2(p));
}

void addCrossings(const glm::vec3 (&corners)[3], double z, const DistanceGrid& grid,
                  std::vector<Crossing>& crossings) {
    glm::dvec2 up{}, down{};  // where the triangle's outline passes the plane
    bool crosses = false;
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 from = corners[k], to = corners[(k + 1) % 3];
        const bool fromAbove = double(from.z) > z, toAbove = double(to.z) > z;
        if (fromAbove == toAbove) continue;
        (toAbove ? up : down) = cut(from, to, z);
        crosses = true;
    }
    if (!crosses) return;
    const int sign = up.y < down.y ? 1 : -1;
    const auto [low, high] = std::minmax(up.y, down.y);
    // Rows with low <= y < high: an end on a row counts as below, as a corner in the plane does.
    const int last = firstFrom(grid, 1, high);
    for (int row = firstFrom(grid, 1, low); row < last; ++row) {
        const double y = grid.center({0, row, 0}).y;
        const double x = up.x + (y - up.y) / (down.y - up.y) * (down.x - up.x);
        const int voxel = firstFrom(grid, 0, x);
        if (voxel < grid.size.x) crossings.push_back({row, voxel, sign});
    }
}

void fill(std::vector<Crossing>& crossings, int width, std::vector<std::uint8_t>& slice) {
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.row, a.voxel) < std::tie(b.row, b.voxel);
    });
    int winding = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const Crossing& from = crossings[i];
        const bool lastOfRow = i + 1 == crossings.size() || crossings[i + 1].row != from.row;
        winding += from.sign;
        const int end = lastOfRow ? width : crossings[i + 1].voxel;
        if (winding != 0) {
            const auto row = slice.begin() + std::ptrdiff_t(from.row) * width;
            std::fill(row + from.voxel, row + end, std::uint8_t(1));
        }
        if (lastOfRow) winding = 0;
    }
    crossings.clear();
}

}  // namespace

InsideSlices::InsideSlices(std::span<const Mesh> meshes, const DistanceGrid& grid)
    : grid_(grid), bySlice_(std::size_t(grid.size.z)) {
    for (std::uint32_t m = 0; m < meshes.size(); ++m) {
        const Mesh& mesh = meshes[m];
        for (const std::uint32_t t : closedTriangles(mesh, meshEdges(mesh))) {
            const glm::uvec3 i = mesh.triangles[t];
            const Triangle triangle{{mesh.positions[i.x], mesh.positions[i.y], mesh.positions[i.z]},
                                    m};
            const auto& [a, b, c] = triangle.corners;
            const int last = firstFrom(grid, 2, std::max({a.z, b.z, c.z}));
            for (int k = firstFrom(grid, 2, std::min({a.z, b.z, c.z})); k < last; ++k)
                bySlice_[std::size_t(k)].push_back(std::uint32_t(triangles_.size()));
            triangles_.push_back(triangle);
        }
    }
}

std::vector<std::uint8_t> InsideSlices::slice(int k) const {
    std::vector<std::uint8_t> result(std::size_t(grid_.size.x) * std::size_t(grid_.size.y), 0);
    const double z = grid_.center({0, 0, k}).z;
    const auto& triangles = bySlice_[std::size_t(k)];
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& triangle = triangles_[triangles[i]];
        addCrossings(triangle.corners, z, grid_, crossings);
        const bool lastOfMesh =
            i + 1 == triangles.size() || triangles_[triangles[i + 1]].mesh != triangle.mesh;
        if (lastOfMesh) fill(crossings, grid_.size.x, result);
    }
    return result;
}

}  // namespace penumbra
