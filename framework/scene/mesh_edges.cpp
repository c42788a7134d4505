#include "scene/mesh_edges.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <tuple>

#include "core/error.h"

namespace penumbra {

namespace {

auto key(glm::vec3 p) { return std::tuple(p.x, p.y, p.z); }  // -0 and 0 compare equal

std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
        return key(positions[i]) < key(positions[j]);
    });
    std::vector<std::uint32_t> welded(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        welded[order[i]] = same ? welded[order[i - 1]] : order[i];
    }
    return welded;
}

// What closedness sums.
int boundary(std::span<const EdgeSide> sides) {
    int sum = 0;
    for (const EdgeSide side : sides) sum += side.direction;
    return sum;
}

glm::dvec3 corner(const Mesh& mesh, glm::uvec3 triangle, int k) {
    return mesh.positions[triangle[k]];
}

}  // namespace

MeshEdges meshEdges(const Mesh& mesh) {
    struct HalfEdge {
        std::uint32_t from, to;
        EdgeSide side;
    };
    MeshEdges result;
    result.welded = weld(mesh.positions);
    std::vector<HalfEdge> halves;
    halves.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        glm::uvec3 corners = mesh.triangles[t];
        for (int k = 0; k < 3; ++k) {
            EXPECTS(corners[k] < mesh.positions.size());
            corners[k] = result.welded[corners[k]];
        }
        if (corners.x == corners.y || corners.y == corners.z || corners.z == corners.x) {
            result.degenerate.push_back(t);
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            halves.push_back({std::min(a, b), std::max(a, b), {t, a < b ? 1 : -1}});
        }
    }
    std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.from, a.to, a.side.triangle) < std::tie(b.from, b.to, b.side.triangle);
    });
    for (const HalfEdge& half : halves) {
        const bool known = !result.edges.empty() && result.edges.back().from == half.from &&
                           result.edges.back().to == half.to;
        if (!known)
            result.edges.push_back({half.from, half.to, std::uint32_t(result.sides.size()), 0});
        ++result.edges.back().sideCount;
        result.sides.push_back(half.side);
    }
    return result;
}

bool closed(const MeshEdges& edges) {
    return std::all_of(edges.edges.begin(), edges.edges.end(),
                       [&](const MeshEdge& edge) { return boundary(edges.sidesOf(edge)) == 0; });
}

std::vector<std::uint32_t> closedTriangles(const Mesh& mesh, const MeshEdges& edges) {
    std::vector<std::uint32_t> parent(mesh.triangles.size());  // a forest: each tree is one part
    std::iota(parent.begin(), parent.end(), 0u);
    const auto part = [&](std::uint32_t t) {
        while (parent[t] != t) t = parent[t] = parent[parent[t]];
        return t;
    };
    for (const MeshEdge& edge : edges.edges)
        for (const EdgeSide side : edges.sidesOf(edge))
            parent[part(side.triangle)] = part(edges.sides[edge.firstSide].triangle);
    std::vector<bool> open(mesh.triangles.size());  // by part
    for (const std::uint32_t t : edges.degenerate) open[t] = true;
    for (const MeshEdge& edge : edges.edges)
        if (boundary(edges.sidesOf(edge)) != 0)
            open[part(edges.sides[edge.firstSide].triangle)] = true;
    std::vector<std::uint32_t> result;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (!open[part(t)]) result.push_back(t);
    return result;
}

MeshReport meshReport(const MeshEdges& edges) {
    MeshReport report;
    report.degenerateTriangles = edges.degenerate.size();
    report.triangles = edges.sides.size() / 3 + report.degenerateTriangles;
    for (const MeshEdge& edge : edges.edges) {
        if (boundary(edges.sidesOf(edge)) == 0) continue;
        if (edge.sideCount == 1)
            ++report.openEdges;
        else if (edge.sideCount % 2 == 1)
            ++report.oddEdges;
        else
            ++report.twistedEdges;
    }
    return report;
}

std::string MeshReport::text() const {
    std::vector<std::string> faults;
    const auto say = [&](std::size_t count, const char* one, const char* many) {
        if (count > 0) faults.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
    };
    say(openEdges, "edge of one triangle", "edges of one triangle");
    say(oddEdges, "edge of an odd number of triangles", "edges of an odd number of triangles");
    say(twistedEdges, "edge whose triangles are wound alike",
        "edges whose triangles are wound alike");
    std::string line = closed() ? "closed" : fmt::format("not closed: {}", fmt::join(faults, ", "));
    if (degenerateTriangles > 0)
        line += fmt::format(" ({} of {} triangles without area left out)", degenerateTriangles,
                            triangles);
    return line;
}

int windingNumber(const Mesh& closedMesh, glm::vec3 point) {
    double halves = 0.0;  // of the signed solid angles
    for (const glm::uvec3 t : closedMesh.triangles) {
        const glm::dvec3 from(point);
        const glm::dvec3 a = corner(closedMesh, t, 0) - from, b = corner(closedMesh, t, 1) - from,
                         c = corner(closedMesh, t, 2) - from;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        const double across = glm::dot(a, glm::cross(b, c));
        const double along =
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
        halves += std::atan2(across, along);
    }
    return int(std::lround(halves / glm::two_pi<double>()));
}

double signedVolume(const Mesh& closedMesh) {
    if (closedMesh.positions.empty()) return 0.0;
    const glm::dvec3 apex(closedMesh.positions.front());  // any point; a near one cancels least
    double sixfold = 0.0;
    for (const glm::uvec3 t : closedMesh.triangles)
        sixfold +=
            glm::dot(corner(closedMesh, t, 0) - apex,
                     glm::cross(corner(closedMesh, t, 1) - apex, corner(closedMesh, t, 2) - apex));
    return sixfold / 6.0;
}

bool facingTrianglesSuffice(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light) {
    if (!closed(edges) || signedVolume(mesh) < 0.0) return false;
    return light.w == 0.0f || windingNumber(mesh, glm::vec3(light)) == 0;
}

}  // namespace penumbra
