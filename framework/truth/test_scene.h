// Small scenes made by hand, for the tests and the benchmark of this layer.
#pragma once

#include <array>
#include <span>

#include "scene/scene.h"

namespace penumbra::testing {

// Counter-clockwise corners of a convex polygon, as a fan.
inline Mesh polygon(std::span<const glm::vec3> corners) {
    Mesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    for (unsigned i = 2; i < corners.size(); ++i) mesh.triangles.push_back({0, i - 1, i});
    return mesh;
}

inline Mesh rectangle(glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
    const std::array corners{corner, corner + u, corner + u + v, corner + v};
    Mesh mesh = polygon(corners);
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return mesh;
}

inline Mesh floorSquare(float size) {
    return rectangle({-size / 2, 0, size / 2}, {size, 0, 0}, {0, 0, -size});
}

// The box of edges u, v, w (right-handed) around `center`.
inline Mesh parallelepiped(glm::vec3 center, glm::vec3 u, glm::vec3 v, glm::vec3 w) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.push_back(center + (i & 1 ? 0.5f : -0.5f) * u + (i & 2 ? 0.5f : -0.5f) * v +
                                 (i & 4 ? 0.5f : -0.5f) * w);
    for (const glm::uvec4 q :
         {glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5), glm::uvec4(0, 1, 5, 4),
          glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6)}) {
        mesh.triangles.push_back({q.x, q.y, q.z});
        mesh.triangles.push_back({q.x, q.z, q.w});
    }
    return mesh;
}

// Latitude-longitude sphere of rings x 2 rings facets.
inline Mesh globe(glm::vec3 center, float radius, unsigned rings) {
    Mesh mesh;
    const unsigned columns = 2 * rings;
    for (unsigned r = 0; r <= rings; ++r)
        for (unsigned c = 0; c < columns; ++c) {
            const float latitude = 3.14159265f * float(r) / float(rings);
            const float longitude = 6.28318531f * float(c) / float(columns);
            mesh.positions.push_back(center +
                                     radius * glm::vec3(glm::sin(latitude) * glm::cos(longitude),
                                                        glm::cos(latitude),
                                                        glm::sin(latitude) * glm::sin(longitude)));
        }
    for (unsigned r = 0; r < rings; ++r)
        for (unsigned c = 0; c < columns; ++c) {
            const unsigned a = r * columns + c, b = r * columns + (c + 1) % columns;
            if (r > 0) mesh.triangles.push_back({a, b, b + columns});
            if (r + 1 < rings) mesh.triangles.push_back({a, b + columns, a + columns});
        }
    return mesh;
}

inline Scene sceneOf(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "test";
    scene.meshes = std::move(meshes);
    scene.materials.push_back({});
    scene.lights.push_back({});
    return scene;
}

}  // namespace penumbra::testing
