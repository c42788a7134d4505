#include "truth/nearest_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace penumbra {

namespace {

constexpr std::uint32_t kLeaf = 4;            // triangles
constexpr double kNotLonger = 1.0 - 0x1p-22;  // than 1, after rounding to float32

double squared(glm::dvec3 v) { return glm::dot(v, v); }

double squaredDistanceToSegment(glm::dvec3 fromA, glm::dvec3 ab) {
    const double length2 = squared(ab), along = glm::dot(fromA, ab);
    if (along <= 0.0 || length2 == 0.0) return squared(fromA);
    return squared(fromA - std::min(along / length2, 1.0) * ab);
}

// To the closed triangle, or `least` if that is smaller. A triangle without area is the segment or
// the point that is left of it.
double squaredDistance(glm::dvec3 point, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, double least) {
    const glm::dvec3 ab = b - a, bc = c - b, ca = a - c;
    const glm::dvec3 fromA = point - a, fromB = point - b, fromC = point - c;
    const glm::dvec3 normal = glm::cross(bc, ca);
    const double normal2 = squared(normal), height = glm::dot(normal, fromA);
    if (height * height >= least * normal2 && normal2 > 0.0) return least;  // its plane is far
    // Above the triangle's inside, the plane is nearest; elsewhere an edge is.
    if (normal2 > 0.0 && glm::dot(glm::cross(ab, fromA), normal) >= 0.0 &&
        glm::dot(glm::cross(bc, fromB), normal) >= 0.0 &&
        glm::dot(glm::cross(ca, fromC), normal) >= 0.0)
        return height * height / normal2;
    return std::min({squaredDistanceToSegment(fromA, ab), squaredDistanceToSegment(fromB, bc),
                     squaredDistanceToSegment(fromC, ca), least});
}

}  // namespace

NearestTriangle::NearestTriangle(std::span<const Mesh> meshes) {
    for (const Mesh& mesh : meshes)
        for (const glm::uvec3 t : mesh.triangles) {
            EXPECTS(std::max({t.x, t.y, t.z}) < mesh.positions.size());
            triangles_.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
        }
    EXPECTS(triangles_.size() < std::numeric_limits<std::uint32_t>::max() / 2);
    nodes_.reserve(2 * triangles_.size() / kLeaf + 2);
    nodes_.emplace_back();
    build(0, 0, std::uint32_t(triangles_.size()));
}

void NearestTriangle::build(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
    Box box, middles;
    glm::dvec3 normals(0.0);  // weighted by area
    for (std::uint32_t i = first; i < last; ++i) {
        const auto& [a, b, c] = triangles_[i];
        for (const glm::vec3 p : {a, b, c}) box.include(p);
        middles.include(a + b + c);
        normals += glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    }
    const double length = glm::length(normals);
    const glm::vec3 across(length > 0.0 ? kNotLonger / length * normals : glm::dvec3(0.0));
    double slabLower = std::numeric_limits<double>::infinity(), slabUpper = -slabLower;
    for (std::uint32_t i = first; i < last; ++i)
        for (const glm::vec3 p : {triangles_[i].a, triangles_[i].b, triangles_[i].c}) {
            const double place = glm::dot(glm::dvec3(across), glm::dvec3(p));
            slabLower = std::min(slabLower, place), slabUpper = std::max(slabUpper, place);
        }
    nodes_[node] = {box.lower, box.upper, across, first, last - first, slabLower, slabUpper};
    if (last - first <= kLeaf) return;
    const glm::vec3 side = middles.upper - middles.lower;
    const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
    const std::uint32_t half = first + (last - first) / 2;
    const auto begin = triangles_.begin();
    std::nth_element(
        begin + first, begin + half, begin + last, [axis](const Triangle& s, const Triangle& t) {
            return s.a[axis] + s.b[axis] + s.c[axis] < t.a[axis] + t.b[axis] + t.c[axis];
        });
    const auto children = std::uint32_t(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = children, nodes_[node].count = 0;
    build(children, first, half);
    build(children + 1, half, last);
}

NearestTriangle::Found NearestTriangle::find(glm::dvec3 point, std::uint32_t guess) const {
    if (empty()) return {std::numeric_limits<double>::infinity(), 0};
    struct Waiting {
        double distance2;
        std::uint32_t node;
    };
    std::array<Waiting, 64> stack;  // depth: at most 32, as halves of 2^32 triangles
    std::size_t waiting = 0;
    std::uint32_t nearest = guess;
    double least = std::numeric_limits<double>::infinity();
    const auto measure = [&](std::uint32_t triangle) {
        const auto& [a, b, c] = triangles_[triangle];
        const double d = squaredDistance(point, a, b, c, least);
        if (d < least) least = d, nearest = triangle;
    };
    const auto distance2 = [&](const Node& node) {
        double box = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double below = double(node.lower[k]) - point[k];
            const double above = point[k] - double(node.upper[k]);
            const double outside = std::max(std::max(below, above), 0.0);
            box += outside * outside;
        }
        const double place = glm::dot(glm::dvec3(node.across), point);
        const double slab = std::max(std::max(node.slabLower - place, place - node.slabUpper), 0.0);
        return std::max(box, slab * slab);
    };
    measure(guess);
    stack[waiting++] = {0.0, 0};
    while (waiting > 0) {
        const Waiting top = stack[--waiting];
        if (top.distance2 >= least) continue;
        const Node& node = nodes_[top.node];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) measure(i);
        if (node.count > 0) continue;
        Waiting children[2];
        for (std::uint32_t k = 0; k < 2; ++k) {
            const Node& child = nodes_[node.first + k];
            children[k] = {distance2(child), node.first + k};
        }
        const bool swap = children[0].distance2 < children[1].distance2;  // the nearer one on top
        for (const Waiting& child : {children[swap], children[!swap]})
            if (child.distance2 < least) stack[waiting++] = child;
    }
    return {std::sqrt(least), nearest};
}

}  // namespace penumbra
