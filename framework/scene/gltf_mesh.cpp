#include <fmt/format.h>

#include <cmath>

#include "scene/gltf_parts.h"

namespace penumbra {

namespace {

enum Mode : std::size_t { kTriangles = 4, kStrip = 5, kFan = 6 };

// Far enough for any scene, near enough that squares and volumes of lengths stay finite floats.
constexpr double kFarthest = 1e9;

glm::uvec3 triangle(std::size_t mode, const std::vector<std::uint32_t>& v, std::size_t i) {
    if (mode == kTriangles) return {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    if (mode == kFan) return {v[0], v[i + 1], v[i + 2]};
    // Every second triangle of a strip turns the other way; glTF swaps its last two.
    return {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]};
}

std::vector<glm::uvec3> assemble(const GltfValue& primitive, std::size_t mode,
                                 const std::vector<std::uint32_t>& vertices) {
    const std::size_t count = vertices.size();
    if (count < 3 || (mode == kTriangles && count % 3 != 0))
        primitive.fail(fmt::format("has {} vertices, which make no whole triangles", count));
    const std::size_t triangles = mode == kTriangles ? count / 3 : count - 2;
    std::vector<glm::uvec3> result;
    result.reserve(triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
        const glm::uvec3 t = triangle(mode, vertices, i);
        const bool seam = t.x == t.y || t.y == t.z || t.z == t.x;  // how strips are joined
        if (mode == kTriangles || !seam) result.push_back(t);
    }
    return result;
}

std::vector<std::uint32_t> vertexOrder(const GltfFile& file, const GltfValue& primitive,
                                       std::size_t vertexCount) {
    if (const auto indices = primitive.find("indices")) {
        auto order = file.indices(indices->index(file.list("accessors").size()));
        for (const std::uint32_t i : order)
            if (i >= vertexCount)
                indices->fail(
                    fmt::format("holds index {}, but there are {} vertices", i, vertexCount));
        return order;
    }
    std::vector<std::uint32_t> order(vertexCount);
    for (std::size_t i = 0; i < vertexCount; ++i) order[i] = std::uint32_t(i);
    return order;
}

glm::vec3 unitOrZero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

// Where a vertex has no normal: the average of its facets', weighted by their area.
void fillNormals(Mesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::dvec3 twiceArea = glm::cross(b - a, c - a);
        for (int k = 0; k < 3; ++k) sums[t[k]] += twiceArea;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (mesh.normals[i] != glm::vec3(0.0f)) continue;
        const glm::vec3 normal = unitOrZero(sums[i]);
        mesh.normals[i] = normal == glm::vec3(0.0f) ? glm::vec3(0, 1, 0) : normal;
    }
}

std::vector<glm::vec3> vectors(const std::vector<float>& values) {
    std::vector<glm::vec3> result;
    result.reserve(values.size() / 3);
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        result.emplace_back(values[i], values[i + 1], values[i + 2]);
    return result;
}

void moveToWorld(Mesh& mesh, const glm::dmat4& worldFromNode, const GltfValue& where) {
    if (worldFromNode != glm::dmat4(1.0)) {  // else bit for bit
        const glm::dmat3 linear(worldFromNode);
        // Cofactors: the inverse transpose up to its scale, and defined where that is not (a mesh
        // that is scaled flat).
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]),
                                   glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        const bool mirrored = glm::determinant(linear) < 0.0;
        const double sign = mirrored ? -1.0 : 1.0;
        for (glm::vec3& p : mesh.positions) p = worldFromNode * glm::dvec4(p, 1.0);
        for (glm::vec3& n : mesh.normals) n = unitOrZero(sign * (cofactors * glm::dvec3(n)));
        if (mirrored)
            for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    }
    for (const glm::vec3 p : mesh.positions)
        if (!(std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest &&
              std::abs(p.z) <= kFarthest))
            where.fail("has a vertex farther than 1e9 from the origin");
}

}  // namespace

std::optional<Mesh> readPrimitive(const GltfFile& file, const GltfValue& primitive,
                                  std::size_t texCoord, const glm::dmat4& worldFromNode) {
    const std::size_t mode = primitive.wholeOr("mode", kTriangles);
    if (mode > kFan) primitive.fail(fmt::format("has mode {}, which is none", mode));
    if (mode < kTriangles) return std::nullopt;
    const std::size_t accessors = file.list("accessors").size();
    const GltfValue attributes = primitive.at("attributes");

    Mesh mesh;
    mesh.positions = vectors(file.floats(attributes.at("POSITION").index(accessors), 3));
    const std::size_t count = mesh.positions.size();
    const auto sameCount = [&](const GltfValue& attribute, std::size_t found) {
        if (found != count)
            attribute.fail(fmt::format("has {} vertices, POSITION {}", found, count));
    };
    if (const auto normals = attributes.find("NORMAL")) {
        mesh.normals = vectors(file.floats(normals->index(accessors), 3));
        sameCount(*normals, mesh.normals.size());
        for (glm::vec3& n : mesh.normals)  // units stay as they are, bit for bit
            if (std::abs(glm::dot(n, n) - 1.0f) > 1e-4f) n = unitOrZero(n);
    } else {
        mesh.normals.assign(count, glm::vec3(0.0f));
    }
    const std::string uvName = fmt::format("TEXCOORD_{}", texCoord);
    if (const auto uvs = attributes.find(uvName.c_str())) {
        const auto values = file.floats(uvs->index(accessors), 2);
        sameCount(*uvs, values.size() / 2);
        for (std::size_t i = 0; i < count; ++i)
            mesh.uvs.emplace_back(values[2 * i], values[2 * i + 1]);
    }
    mesh.triangles = assemble(primitive, mode, vertexOrder(file, primitive, count));
    moveToWorld(mesh, worldFromNode, primitive);
    fillNormals(mesh);
    if (mesh.triangles.empty()) return std::nullopt;
    return mesh;
}

}  // namespace penumbra
