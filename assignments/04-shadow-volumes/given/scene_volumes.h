// The shadow volumes of a scene's meshes, as index buffers over one vertex buffer that holds every
// position twice: (p, 1) and (p, 0), the twin that extruded() sends to infinity.
//
//   SceneVolumes volumes(scene);
//   LightVolumes& shadows = volumes.ofLight(0, light.position(), VolumeKind::silhouette);
//   volumes.bind();
//   shadows.draw({{.mesh = 3, .caps = true}}, [] { … exchange front and back … });
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "shadow_volumes.h"

namespace penumbra {

enum class VolumeKind { silhouette, perTriangle };

struct MeshVolume {
    bool allTriangles = false;
    std::vector<int> weights;       // by triangle
    std::vector<int> sums;          // by edge; empty for perTriangle, which knows no edges
    std::vector<glm::uvec3> sides;  // vertex numbers of the mesh and twins
    VolumeTriangles caps;
};

// What never changes while the scene rests.
struct CasterMesh {
    MeshEdges edges;
    MeshReport report;
    GLuint firstVertex = 0;  // in the vertex buffer: first the mesh's vertices, then their twins
};

// Calls your functions and looks through what they return, so that no bad index reaches the driver.
// Throws Error.
MeshVolume meshVolume(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light, VolumeKind kind);

// One light's volumes, built when asked for and kept until the light moves.
class LightVolumes {
public:
    LightVolumes(const std::vector<Mesh>& meshes, const std::vector<CasterMesh>& casters,
                 glm::vec4 light, VolumeKind kind);
    ~LightVolumes();
    LightVolumes(const LightVolumes&) = delete;
    LightVolumes& operator=(const LightVolumes&) = delete;

    const MeshVolume& ofMesh(std::size_t mesh);
    bool isFor(glm::vec4 light, VolumeKind kind) const { return light == light_ && kind == kind_; }

    // One caster to be drawn.
    struct Part {
        std::size_t mesh;
        bool caps;
        bool operator==(const Part&) const = default;
    };
    // Two draw calls: what faces out of the volumes, then, after `exchange`, what faces into them.
    void draw(const std::vector<Part>& parts, const std::function<void()>& exchange);
    void drawLines(const std::vector<GLuint>& ends);

private:
    void fillBuffer(const std::vector<Part>& parts);

    const std::vector<Mesh>& meshes_;
    const std::vector<CasterMesh>& casters_;
    glm::vec4 light_;
    VolumeKind kind_;
    std::vector<std::optional<MeshVolume>> volumes_;
    GLuint buffer_ = 0;
    std::vector<Part> inBuffer_;
    GLsizei outwardIndices_ = 0, inwardIndices_ = 0;
};

class SceneVolumes {
public:
    explicit SceneVolumes(const Scene& scene);
    ~SceneVolumes();
    SceneVolumes(const SceneVolumes&) = delete;
    SceneVolumes& operator=(const SceneVolumes&) = delete;

    bool isFor(const Scene& scene) const { return scene.meshes == meshes_; }
    const std::vector<CasterMesh>& casters() const { return casters_; }
    LightVolumes& ofLight(std::size_t index, glm::vec4 light, VolumeKind kind);
    void forget() { lights_.clear(); }
    void bind() const { glBindVertexArray(vertexArray_); }

private:
    std::vector<Mesh> meshes_;
    std::vector<CasterMesh> casters_;
    std::vector<std::unique_ptr<LightVolumes>> lights_;
    GLuint vertexArray_ = 0, vertexBuffer_ = 0;
};

}  // namespace penumbra
