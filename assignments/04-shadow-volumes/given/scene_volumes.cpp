#include "scene_volumes.h"

#include <algorithm>
#include <cstdlib>

#include "core/error.h"

namespace penumbra {

namespace {

void expectSize(const char* function, const char* file, std::size_t got, std::size_t wanted) {
    if (got != wanted)
        throw Error(std::string(function) + "() returns " + std::to_string(got) + " values", file,
                    "return one for each of the " + std::to_string(wanted));
}

void expectWeights(const std::vector<int>& weights, const Mesh& mesh, bool all) {
    const char* function = all ? "allTriangles" : "facingTriangles";
    const char* file = all ? "open_meshes.cpp" : "silhouette.cpp";
    expectSize(function, file, weights.size(), mesh.triangles.size());
    for (const int weight : weights)
        if (weight < (all ? -1 : 0) || weight > 1)
            throw Error(std::string(function) + "() returns " + std::to_string(weight), file,
                        all ? "weights are -1, 0 or 1" : "weights are 0 or 1");
}

void expectSums(const std::vector<int>& sums, const MeshEdges& edges) {
    expectSize("edgeSums", "silhouette.cpp", sums.size(), edges.edges.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (sums[i] < -int(edges.edges[i].sideCount) || sums[i] > int(edges.edges[i].sideCount))
            throw Error("edgeSums() returns " + std::to_string(sums[i]), "silhouette.cpp",
                        "an edge of n triangles sums to -n … n");
}

void expectVertices(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                    const char* function, const char* file) {
    for (const glm::uvec3 t : triangles)
        for (int k = 0; k < 3; ++k)
            if (t[k] >= 2 * vertices)
                throw Error(std::string(function) + "() names vertex " + std::to_string(t[k]), file,
                            "the mesh and its twins have " + std::to_string(2 * vertices));
}

}  // namespace

MeshVolume meshVolume(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light, VolumeKind kind) {
    const auto farOffset = std::uint32_t(mesh.positions.size());
    const bool directional = light.w == 0;
    MeshVolume volume;
    volume.allTriangles = kind == VolumeKind::perTriangle || needsAllTriangles(mesh, edges, light);
    volume.weights = volume.allTriangles ? allTriangles(mesh, light) : facingTriangles(mesh, light);
    expectWeights(volume.weights, mesh, volume.allTriangles);

    const auto side = [&](std::uint32_t from, std::uint32_t to, int times) {
        if (times < 0) std::swap(from, to);
        for (int i = 0; i < std::abs(times); ++i)
            appendSide(from, to, farOffset, directional, volume.sides);
    };
    if (kind == VolumeKind::silhouette) {
        volume.sums = edgeSums(edges, volume.weights);
        expectSums(volume.sums, edges);
        for (std::size_t i = 0; i < volume.sums.size(); ++i)
            side(edges.edges[i].from, edges.edges[i].to, volume.sums[i]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const int weight = volume.weights[i];
        if (weight == 0) continue;
        appendCaps(t, weight, farOffset, directional, volume.caps);
        if (kind == VolumeKind::perTriangle)
            for (int k = 0; k < 3; ++k) side(t[k], t[(k + 1) % 3], weight);
    }
    expectVertices(volume.sides, mesh.positions.size(), "appendSide", "sides.cpp");
    expectVertices(volume.caps.outward, mesh.positions.size(), "appendCaps", "z_fail.cpp");
    expectVertices(volume.caps.inward, mesh.positions.size(), "appendCaps", "z_fail.cpp");
    return volume;
}

LightVolumes::LightVolumes(const std::vector<Mesh>& meshes, const std::vector<CasterMesh>& casters,
                           glm::vec4 light, VolumeKind kind)
    : meshes_(meshes), casters_(casters), light_(light), kind_(kind), volumes_(meshes.size()) {
    glGenBuffers(1, &buffer_);
}

LightVolumes::~LightVolumes() { glDeleteBuffers(1, &buffer_); }

const MeshVolume& LightVolumes::ofMesh(std::size_t mesh) {
    auto& volume = volumes_[mesh];
    if (!volume) volume = meshVolume(meshes_[mesh], casters_[mesh].edges, light_, kind_);
    return *volume;
}

// Sides and outward caps of all parts, then inward caps of all parts.
void LightVolumes::fillBuffer(const std::vector<Part>& parts) {
    std::vector<glm::uvec3> triangles;
    const auto append = [&](const std::vector<glm::uvec3>& some, GLuint firstVertex) {
        for (const glm::uvec3 t : some) triangles.push_back(t + firstVertex);
    };
    for (const Part part : parts) {
        const GLuint firstVertex = casters_[part.mesh].firstVertex;
        append(ofMesh(part.mesh).sides, firstVertex);
        if (part.caps) append(ofMesh(part.mesh).caps.outward, firstVertex);
    }
    outwardIndices_ = GLsizei(3 * triangles.size());
    for (const Part part : parts)
        if (part.caps) append(ofMesh(part.mesh).caps.inward, casters_[part.mesh].firstVertex);
    inwardIndices_ = GLsizei(3 * triangles.size()) - outwardIndices_;
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(triangles.size() * sizeof(glm::uvec3)),
                 triangles.data(), GL_STREAM_DRAW);
    inBuffer_ = parts;
}

void LightVolumes::draw(const std::vector<Part>& parts, const std::function<void()>& exchange) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer_);
    if (parts != inBuffer_) fillBuffer(parts);
    if (outwardIndices_ > 0)
        glDrawElements(GL_TRIANGLES, outwardIndices_, GL_UNSIGNED_INT, nullptr);
    if (inwardIndices_ == 0) return;
    exchange();
    glDrawElements(GL_TRIANGLES, inwardIndices_, GL_UNSIGNED_INT,
                   reinterpret_cast<void*>(std::size_t(outwardIndices_) * sizeof(GLuint)));
}

void LightVolumes::drawLines(const std::vector<GLuint>& ends) {
    inBuffer_.clear();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(ends.size() * sizeof(GLuint)), ends.data(),
                 GL_STREAM_DRAW);
    glDrawElements(GL_LINES, GLsizei(ends.size()), GL_UNSIGNED_INT, nullptr);
}

SceneVolumes::SceneVolumes(const Scene& scene) : meshes_(scene.meshes) {
    std::vector<glm::vec4> vertices;
    for (const Mesh& mesh : meshes_) {
        MeshEdges edges = meshEdges(mesh);
        const MeshReport report = meshReport(edges);
        casters_.push_back({std::move(edges), report, GLuint(vertices.size())});
        for (const float w : {1.0f, 0.0f})
            for (const glm::vec3 p : mesh.positions) vertices.emplace_back(p, w);
    }
    glGenVertexArrays(1, &vertexArray_);
    glBindVertexArray(vertexArray_);
    glGenBuffers(1, &vertexBuffer_);
    glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(glm::vec4)), vertices.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glBindVertexArray(0);
}

SceneVolumes::~SceneVolumes() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &vertexBuffer_);
}

LightVolumes& SceneVolumes::ofLight(std::size_t index, glm::vec4 light, VolumeKind kind) {
    if (lights_.size() <= index) lights_.resize(index + 1);
    if (!lights_[index] || !lights_[index]->isFor(light, kind))
        lights_[index] = std::make_unique<LightVolumes>(meshes_, casters_, light, kind);
    return *lights_[index];
}

}  // namespace penumbra
