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

void append(Mesh& mesh, const Mesh& other) {
    EXPECTS(mesh.positions.empty() || mesh.uvs.empty() == other.uvs.empty());
    const auto first = unsigned(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const glm::uvec3 t : other.triangles) mesh.triangles.push_back(t + first);
}

}  // namespace penumbra
