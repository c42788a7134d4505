#include "scene/shapes.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/error.h"

namespace penumbra {

Mesh quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, int material) {
    // The diagonals span the plane even where one corner coincides with its neighbour.
    const glm::vec3 normal = glm::normalize(glm::cross(c - a, d - b));
    Mesh mesh;
    mesh.name = "quad";
    mesh.positions = {a, b, c, d};
    mesh.normals.assign(4, normal);
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.material = material;
    return mesh;
}

Mesh box(glm::vec3 lower, glm::vec3 upper, int material) {
    EXPECTS(lower.x < upper.x && lower.y < upper.y && lower.z < upper.z);
    const auto corner = [&](int x, int y, int z) {
        return glm::vec3(x ? upper.x : lower.x, y ? upper.y : lower.y, z ? upper.z : lower.z);
    };
    Mesh mesh = quad(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), material);
    mesh.name = "box";
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        append(mesh, quad(a, b, c, d, material));
    };
    add(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));  // -x
    add(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));  // +y
    add(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));  // -y
    add(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));  // +z
    add(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));  // -z
    return mesh;
}

Mesh sphere(glm::vec3 center, float radius, int rings, int material) {
    EXPECTS(rings >= 2 && radius > 0.0f);
    const int segments = 2 * rings;
    Mesh mesh;
    mesh.name = "sphere";
    mesh.material = material;
    for (int ring = 0; ring <= rings; ++ring) {
        const double theta = glm::pi<double>() * ring / rings;  // from the north pole
        for (int segment = 0; segment <= segments; ++segment) {
            const double phi = glm::two_pi<double>() * (segment % segments) / segments;
            const bool pole = ring == 0 || ring == rings;
            const double r = pole ? 0.0 : std::sin(theta);
            const glm::vec3 normal(r * std::cos(phi), std::cos(theta), -r * std::sin(phi));
            mesh.positions.push_back(center + radius * normal);
            mesh.normals.push_back(normal);
            mesh.uvs.emplace_back(float(segment) / float(segments), float(ring) / float(rings));
        }
    }
    const auto index = [&](int ring, int segment) {
        return unsigned(ring * (segments + 1) + segment);
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int s = 0; s < segments; ++s) {  // at a pole one of the two triangles has no area
            if (ring + 1 < rings)
                mesh.triangles.emplace_back(index(ring, s), index(ring + 1, s),
                                            index(ring + 1, s + 1));
            if (ring > 0)
                mesh.triangles.emplace_back(index(ring, s), index(ring + 1, s + 1),
                                            index(ring, s + 1));
        }
    return mesh;
}

Mesh ground(float size, int cells, int material) {
    EXPECTS(size > 0.0f && cells >= 1);
    Mesh mesh;
    mesh.name = "ground";
    mesh.material = material;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const glm::vec2 uv(float(column) / float(cells), float(row) / float(cells));
            mesh.positions.emplace_back(size * (uv.x - 0.5f), 0.0f, size * (uv.y - 0.5f));
            mesh.normals.emplace_back(0, 1, 0);
            mesh.uvs.push_back(uv);
        }
    const auto index = [&](int row, int column) { return unsigned(row * (cells + 1) + column); };
    for (int row = 0; row < cells; ++row)
        for (int c = 0; c < cells; ++c) {
            mesh.triangles.emplace_back(index(row, c), index(row + 1, c), index(row + 1, c + 1));
            mesh.triangles.emplace_back(index(row, c), index(row + 1, c + 1), index(row, c + 1));
        }
    return mesh;
}

Mesh lathe(glm::vec3 foot, const std::vector<glm::vec2>& outline, int segments, int material) {
    EXPECTS(outline.size() >= 3 && segments >= 3);
    EXPECTS(outline.front().x == 0.0f && outline.back().x == 0.0f);
    Mesh mesh;
    mesh.name = "lathe";
    mesh.material = material;
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        const glm::vec2 low = outline[i], high = outline[i + 1];
        const glm::vec2 along = glm::normalize(high - low);
        const auto first = unsigned(mesh.positions.size());
        for (int s = 0; s <= segments; ++s) {
            // The last ring closes on the first's very numbers.
            const double phi = glm::two_pi<double>() * (s % segments) / segments;
            const auto c = float(std::cos(phi)), d = -float(std::sin(phi));
            for (const glm::vec2 p : {low, high}) {
                mesh.positions.push_back(foot + glm::vec3(p.x * c, p.y, p.x * d));
                mesh.normals.push_back(
                    glm::normalize(glm::vec3(along.y * c, -along.x, along.y * d)));
                mesh.uvs.emplace_back(float(s) / float(segments), p == low ? 0.0f : 1.0f);
            }
            if (s == segments) continue;
            const unsigned a = first + 2 * unsigned(s);
            if (low.x > 0.0f) mesh.triangles.emplace_back(a, a + 2, a + 1);
            if (high.x > 0.0f) mesh.triangles.emplace_back(a + 1, a + 2, a + 3);
        }
    }
    return mesh;
}

Mesh cylinder(glm::vec3 foot, float radius, float height, int segments, int material) {
    EXPECTS(radius > 0.0f && height > 0.0f);
    return lathe(foot, {{0, 0}, {radius, 0}, {radius, height}, {0, height}}, segments, material);
}

Mesh torus(glm::vec3 center, float ring, float tube, int segments, int tubeSegments, int material) {
    EXPECTS(ring > tube && tube > 0.0f && segments >= 3 && tubeSegments >= 3);
    Mesh mesh;
    mesh.name = "torus";
    mesh.material = material;
    for (int s = 0; s <= segments; ++s)
        for (int t = 0; t <= tubeSegments; ++t) {
            const double phi = glm::two_pi<double>() * (s % segments) / segments;
            const double theta = glm::two_pi<double>() * (t % tubeSegments) / tubeSegments;
            const glm::dvec3 out(std::cos(phi), 0.0, -std::sin(phi));
            const glm::vec3 normal = std::cos(theta) * out + glm::dvec3(0, std::sin(theta), 0);
            mesh.positions.push_back(center + ring * glm::vec3(out) + tube * normal);
            mesh.normals.push_back(normal);
            mesh.uvs.emplace_back(float(s) / float(segments), float(t) / float(tubeSegments));
        }
    const auto index = [&](int s, int t) { return unsigned(s * (tubeSegments + 1) + t); };
    for (int s = 0; s < segments; ++s)
        for (int t = 0; t < tubeSegments; ++t) {
            mesh.triangles.emplace_back(index(s, t), index(s + 1, t), index(s + 1, t + 1));
            mesh.triangles.emplace_back(index(s, t), index(s + 1, t + 1), index(s, t + 1));
        }
    return mesh;
}

Mesh arch(glm::vec3 center, float inner, float outer, float depth, int segments, int material) {
    EXPECTS(outer > inner && inner > 0.0f && depth > 0.0f && segments >= 1);
    const auto corner = [&](int s, bool outside, bool front) {
        const double phi = glm::pi<double>() * s / segments;
        const glm::dvec2 direction = s == segments ? glm::dvec2(-1, 0)  // sin(pi) is not quite 0
                                                   : glm::dvec2(std::cos(phi), std::sin(phi));
        const glm::vec2 p = double(outside ? outer : inner) * direction;
        return center + glm::vec3(p.x, p.y, front ? 0.5f * depth : -0.5f * depth);
    };
    Mesh mesh;
    const auto face = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        append(mesh, quad(a, b, c, d, material));
    };
    for (int s = 0; s < segments; ++s) {
        const int n = s + 1;
        face(corner(s, 1, 0), corner(n, 1, 0), corner(n, 1, 1), corner(s, 1, 1));  // outside
        face(corner(s, 0, 1), corner(n, 0, 1), corner(n, 0, 0), corner(s, 0, 0));  // inside
        face(corner(s, 0, 1), corner(s, 1, 1), corner(n, 1, 1), corner(n, 0, 1));  // front
        face(corner(s, 1, 0), corner(s, 0, 0), corner(n, 0, 0), corner(n, 1, 0));  // back
    }
    face(corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1), corner(0, 0, 1));  // feet, face down
    const int last = segments;
    face(corner(last, 1, 0), corner(last, 0, 0), corner(last, 0, 1), corner(last, 1, 1));
    mesh.name = "arch";
    mesh.material = material;
    return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
    EXPECTS(mesh.positions.empty() || mesh.uvs.empty() == other.uvs.empty());
    const auto first = unsigned(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const glm::uvec3 t : other.triangles) mesh.triangles.push_back(t + first);
}

}  // namespace penumbra
