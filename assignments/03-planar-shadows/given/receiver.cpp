#include "receiver.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

using glm::dvec3;

namespace {

// Twice the triangle's area long.
dvec3 areaNormal(const Mesh& mesh, glm::uvec3 t) {
    const dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    return glm::cross(b - a, c - a);
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3 t : mesh.triangles) sum += 0.5 * glm::length(areaNormal(mesh, t));
    return sum;
}

}  // namespace

std::size_t receiverOf(const Scene& scene) {
    for (const char* name : {"receiver", "ground"})
        for (std::size_t i = 0; i < scene.meshes.size(); ++i)
            if (scene.meshes[i].name == name) return i;
    std::size_t best = 0;
    double largest = -1;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        if (const double a = area(scene.meshes[i]); a > largest) largest = a, best = i;
    return best;
}

std::optional<glm::vec4> planeOf(const Mesh& mesh) {
    dvec3 normal(0.0), middle(0.0);
    for (const glm::uvec3 t : mesh.triangles) {
        const dvec3 n = areaNormal(mesh, t);
        normal += glm::dot(n, normal) < 0 ? -n : n;  // two-sided: triangles may be wound either way
    }
    if (!(glm::length(normal) > 0)) return std::nullopt;
    normal = glm::normalize(normal);
    for (const dvec3 p : mesh.positions) middle += p / double(mesh.positions.size());
    const double d = -glm::dot(normal, middle);

    double coordinate = 0, deviation = 0;
    for (const dvec3 p : mesh.positions) {
        coordinate = std::max({coordinate, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        deviation = std::max(deviation, std::abs(glm::dot(normal, p) + d));
    }
    if (deviation > std::ldexp(coordinate, -20)) return std::nullopt;
    return glm::vec4(normal, d);
}

Scene withoutColor(const Scene& scene, std::vector<Mesh> meshes) {
    Scene part;
    part.meshes = std::move(meshes);
    part.materials = scene.materials;
    if (std::any_of(part.materials.begin(), part.materials.end(),
                    [](const Material& m) { return m.alphaCutoff > 0; }))
        part.textures = scene.textures;
    else
        for (Material& m : part.materials) m.texture = -1;
    return part;
}

void tilt(Mesh& mesh, float angleRadians) {
    const glm::vec3 middle = bounds(mesh).center();
    const float c = std::cos(angleRadians), s = std::sin(angleRadians);
    const glm::mat3 rotation(c, s, 0, -s, c, 0, 0, 0, 1);
    for (glm::vec3& p : mesh.positions) p = middle + rotation * (p - middle);
    for (glm::vec3& n : mesh.normals) n = rotation * n;
}

}  // namespace penumbra
