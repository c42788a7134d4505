// A scene is plain data in world space: triangles, base colours with alpha masks, one camera, its
// lights. Importers and the gallery make it; rasteriser and ray tracer read it.
//
//   Scene scene = loadScene("fence@7");            // gallery.h: name, installed model, or path
//   Box box = bounds(scene);
//   float cutoff = scene.materials[mesh.material].alphaCutoff;
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/light.h"

namespace penumbra {

// sRGB base colour with straight (not premultiplied) alpha; row 0 is at v = 0, as in glTF.
struct Texture2D {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // 4 bytes a texel

    bool operator==(const Texture2D&) const = default;
};

struct Material {
    std::string name;
    glm::vec3 baseColor{0.8f};  // linear; multiplies the texture
    int texture = -1;           // index into Scene::textures, -1 = none
    float alphaCutoff = 0.0f;   // > 0: alpha mask; where the texture's alpha is below, it is a hole
    glm::vec3 emissive{0.0f};   // linear; light of its own, which no shadow touches

    bool operator==(const Material&) const = default;
};

// All vectors of vertices have one length, or are empty (uvs). Triangles are seen and cast shadows
// from both sides.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;  // world units
    std::vector<glm::vec3> normals;    // unit; for shading only, visibility uses the facet's plane
    std::vector<glm::vec2> uvs;        // glTF: v grows downwards; empty = none
    std::vector<glm::uvec3> triangles;
    int material = 0;

    bool operator==(const Mesh&) const = default;
};

struct Box {
    glm::vec3 lower{1e30f};
    glm::vec3 upper{-1e30f};

    bool empty() const { return lower.x > upper.x; }
    glm::vec3 center() const { return 0.5f * (lower + upper); }
    float diagonal() const { return empty() ? 0.0f : glm::length(upper - lower); }
    void include(glm::vec3 p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
};

struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture2D> textures;
    Camera camera;
    std::vector<Light> lights;  // at least one; the first is the key light
};

Box bounds(const Mesh& mesh);
Box bounds(std::span<const Mesh> meshes);
Box bounds(const Scene& scene);
std::size_t triangleCount(const Scene& scene);

// Every length times `factor`, of light and camera, too. A power of two rounds nothing.
Scene scaled(Scene scene, float factor);

}  // namespace penumbra
