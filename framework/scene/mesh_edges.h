// Which triangles of a mesh meet at which edge, and whether together they close a space: for
// silhouettes, shadow volumes and outlines.
//
//   MeshEdges edges = meshEdges(mesh);
//   for (const MeshEdge& edge : edges.edges)
//       for (const EdgeSide side : edges.sidesOf(edge)) sum += facing[side.triangle] *
//       side.direction;
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

//         to
//        / | \        The left triangle has corners from, to, left in this order: direction +1.
//       /  |  \       The right one has to, from, right: direction -1. Around any consistently
//   left   |  right   wound surface the two alternate, and an edge between a facing and an
//       \  |  /       averted triangle is a silhouette.
//        \ | /
//        from
struct EdgeSide {
    std::uint32_t triangle;
    int direction;  // +1: the triangle runs from -> to; -1: to -> from
};

// Ends are vertices of the mesh: of all vertices at one position the first. Two sides are usual;
// one is a border; three and more happen in models.
struct MeshEdge {
    std::uint32_t from, to;  // from < to
    std::uint32_t firstSide, sideCount;
};

struct MeshEdges {
    std::vector<MeshEdge> edges;            // sorted by (from, to): the same on every system
    std::vector<EdgeSide> sides;            // edge by edge, triangles ascending
    std::vector<std::uint32_t> welded;      // by vertex: the first vertex at its position
    std::vector<std::uint32_t> degenerate;  // triangles with two corners at one position

    std::span<const EdgeSide> sidesOf(const MeshEdge& edge) const {
        return std::span(sides).subspan(edge.firstSide, edge.sideCount);
    }
};

// Vertices weld where their positions are equal (-0 is 0), with no tolerance: hard-edged facets
// carry copies of one corner, but near is not equal. A degenerate triangle has no edges here: it
// runs along its one edge forth and back, which cancels. One with three corners on a line keeps its
// edges: they do the work of closing a T-junction.
MeshEdges meshEdges(const Mesh& mesh);

// Every edge is run as often from -> to as to -> from, so the surface has no border. How many
// triangles meet there does not matter. Empty meshes are closed.
bool closed(const MeshEdges& edges);

// The triangles of the mesh's closed parts, ascending: of all triangles that hang together over
// edges, either all are here or none. So a lamp with an open shade keeps the inside of its foot.
std::vector<std::uint32_t> closedTriangles(const Mesh& mesh, const MeshEdges& edges);

// Edges by what is wrong with them; a closed mesh has none. A T-junction shows as open edges: the
// long edge on one side and its halves on the other have no partner.
struct MeshReport {
    std::size_t triangles = 0;
    std::size_t openEdges = 0;     // one triangle
    std::size_t oddEdges = 0;      // 3, 5, … triangles
    std::size_t twistedEdges = 0;  // an even number, but not half of them each way: winding differs
    std::size_t degenerateTriangles = 0;  // harmless

    bool closed() const { return openEdges + oddEdges + twistedEdges == 0; }
    // One line: "closed", or "not closed: 4 open edges, 1 edge of 3 or more triangles, odd; …"
    std::string text() const;
};
MeshReport meshReport(const MeshEdges& edges);

// How often the closed mesh wraps around the point, counter-clockwise triangles seen from outside:
// 0 outside, 1 inside, -1 inside a mesh that is inside out, 2 where two solids of the mesh overlap.
// Sums solid angles [van Oosterom and Strackee 1983]; the point must not lie on the surface.
int windingNumber(const Mesh& closedMesh, glm::vec3 point);

// The volume that a closed mesh encloses, negative where it is inside out.
double signedVolume(const Mesh& closedMesh);

// Whether the triangles that face the light are all that its shadow needs. True for a closed mesh
// that is not inside out and does not hold the light (position as Light::position()): from such a
// light every ray's first crossing is a facing triangle. Otherwise every triangle counts.
bool facingTrianglesSuffice(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light);

}  // namespace penumbra
