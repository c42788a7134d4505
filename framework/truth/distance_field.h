// The signed distance field of triangle meshes on a regular grid: how far it is from each voxel's
// centre to the nearest triangle, negative inside closed meshes.
//
//   const DistanceGrid grid = DistanceGrid::around(bounds(blockers), 128);
//   const DistanceField field = distanceField(blockers, grid, &progress);
//   volume.upload(field.values);          // gl/volume_texture.h
//   float distance = field.sample(point);  // as the shader's texture() will give it
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/progress.h"
#include "scene/scene.h"

namespace penumbra {

//            upper()
//    +---+---+         The centre of voxel (i, j, k) is lower + (vec3(i, j, k) + 0.5) * cell, so a
//    | · | · |         texture's (u, v, w) of a point is (point - lower) / (vec3(size) * cell).
//    +---+---+  cell
//    | · | · |
//    +---+---+
//  lower
struct DistanceGrid {
    glm::vec3 lower{0.0f};  // corner of the grid's box
    float cell = 0.0f;      // edge of a voxel, world units
    glm::ivec3 size{0};     // voxels

    glm::vec3 upper() const { return lower + glm::vec3(size) * cell; }
    glm::dvec3 center(glm::ivec3 voxel) const {
        return glm::dvec3(lower) + (glm::dvec3(voxel) + 0.5) * double(cell);
    }
    std::size_t count() const {
        return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    }
    bool operator==(const DistanceGrid&) const = default;

    // `voxels` along the longest side, at least `padding` of them empty at each end of each axis.
    // Throws Error where the box is empty or a point.
    static DistanceGrid around(const Box& box, int voxels, int padding = 2);
};

// Values are exact to float32 rounding at voxel centres; between them a trilinear look-up is off by
// at most half a voxel's diagonal, as distance changes no faster than one per unit. So walls much
// thinner than two voxels have no reliable inside.
//
// Outside the grid's box, look up at q, the point of the box nearest to p. All triangles lie in the
// box, if the grid was made around them, and the box is convex, so the true distance lies
//   between  sqrt(|p - q|² + value(q)²)  and  |p - q| + value(q).
// March with the former. The latter oversteps.
struct DistanceField {
    DistanceGrid grid;
    std::vector<float> values;  // x fastest, then y, then z; empty: cancelled

    float at(glm::ivec3 voxel) const {
        return values[(std::size_t(voxel.z) * std::size_t(grid.size.y) + std::size_t(voxel.y)) *
                          std::size_t(grid.size.x) +
                      std::size_t(voxel.x)];
    }
    // Trilinear, clamped to the outermost centres: GL_LINEAR with GL_CLAMP_TO_EDGE.
    float sample(glm::vec3 point) const;
};

// Distance is that to the nearest triangle of any mesh, 0 on it. A voxel is inside where the closed
// parts of some mesh (closedTriangles() of mesh_edges.h) together wind around it other than 0
// times: nested and overlapping solids are inside, cavities are not, and a mesh turned inside out
// has the inside that it would have otherwise. Open parts have two outsides. Holes of alpha masks
// are not seen.
//
// On all cores, the same for any number of them; one step of `progress` a slice (grid.size.z).
// Throws Error where there is no triangle. Returns early, without values, when progress->cancelled
// is set.
DistanceField distanceField(std::span<const Mesh> meshes, const DistanceGrid& grid,
                            Progress* progress = nullptr);

}  // namespace penumbra
