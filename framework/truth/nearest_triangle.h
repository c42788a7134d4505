// The distance from a point to the nearest of many triangles, exact to float64 rounding.
//
//   NearestTriangle nearest(meshes);
//   NearestTriangle::Found found = nearest.find(point);
//   found = nearest.find(neighbour, found.triangle);   // starts with a good bound: much faster
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

// A tree of boxes [Kay and Kajiya 1986] over all triangles of the meshes, searched nearest box
// first. Everything is computed in float64: what a search returns does not depend on its guess but
// for the last bits, nor on threads. (Embree's point queries compare boxes in float32, relative to
// coordinates, and need float32 points: too coarse far from the origin.)
class NearestTriangle {
public:
    explicit NearestTriangle(std::span<const Mesh> meshes);

    struct Found {
        double distance;         // to the closed triangle; infinity where there is none
        std::uint32_t triangle;  // of this object's own order: good for a guess, no more
    };
    // `guess` bounds the search from above: the triangle found for a point nearby.
    Found find(glm::dvec3 point, std::uint32_t guess = 0) const;

    bool empty() const { return triangles_.empty(); }

private:
    struct Triangle {
        glm::vec3 a, b, c;
    };
    // A node's triangles lie in its box and in its slab, the space between two planes across their
    // mean normal. Boxes are loose around surfaces aslant, where slabs are tight: without these, a
    // point inside a fine sphere is as near to hundreds of boxes as to the nearest triangle.
    struct Node {
        glm::vec3 lower, upper;
        glm::vec3 across;             // at most of length 1; 0 where normals cancel
        std::uint32_t first;          // triangle of a leaf, or an inner node's first child
        std::uint32_t count;          // triangles; 0 = inner node, whose children lie side by side
        double slabLower, slabUpper;  // of dot(across, p)
    };

    void build(std::uint32_t node, std::uint32_t first, std::uint32_t last);

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace penumbra
