// Which voxel centres lie inside closed meshes, slice by slice.
//
//   const InsideSlices inside(meshes, grid);
//   std::vector<std::uint8_t> slice = inside.slice(k);   // 1 inside, x fastest
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "truth/distance_field.h"

namespace penumbra {

// A solid is cut twice, and winding is counted along what is left.
//
// - The plane z = z_k of voxel centres cuts each triangle that has corners on both sides (a corner
//   in the plane counts as below it) in a segment. Its ends are computed from the triangle's two
//   edges, each in the order of its ends' coordinates, so that the triangles at an edge get the
//   same point to the bit. Hence the segments form closed loops, as the triangles form closed
//   surfaces: each edge is run as often up as down.
// - The row y = y_j cuts each segment that has ends on both sides. Around a loop these crossings
//   alternate between up and down, so their signed sum from one end of the row to a voxel is the
//   loops' winding number there.
//
// Only comparisons decide what crosses what, and each is asked of the same two numbers wherever it
// matters: no crossing is lost or found twice, at edges, corners and faces in the plane neither.
// Rounding only moves a segment's ends and a crossing's place, by some ulps of float64: loops stay
// closed, and a winding number does not change where the curve that moves does not pass. So a
// centre can be misjudged only where its distance is some float64 ulps of the coordinates, which
// float32 positions do not resolve.
class InsideSlices {
public:
    InsideSlices(std::span<const Mesh> meshes, const DistanceGrid& grid);

    // Any thread may ask for any slice.
    std::vector<std::uint8_t> slice(int k) const;

private:
    struct Triangle {
        glm::vec3 corners[3];
        std::uint32_t mesh;
    };
    DistanceGrid grid_;
    std::vector<Triangle> triangles_;                  // of closed parts, mesh by mesh
    std::vector<std::vector<std::uint32_t>> bySlice_;  // of these, the ones that may cross it
};

}  // namespace penumbra
