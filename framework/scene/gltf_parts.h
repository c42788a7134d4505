// The parts of the glTF reader; loadGltf() in gltf.cpp puts them together.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/scene.h"

namespace penumbra {

// gltf_material.cpp
struct GltfMaterials {
    std::vector<Material> materials;    // one a glTF material
    std::vector<Texture2D> textures;    // base colours only
    std::vector<std::size_t> texCoord;  // by material: which TEXCOORD_n
    std::vector<bool> invisible;        // by material: nothing of it is left by its alpha test
};
GltfMaterials readMaterials(const GltfFile& file);

// gltf_mesh.cpp: one mesh in world space; none for points and lines.
std::optional<Mesh> readPrimitive(const GltfFile& file, const GltfValue& primitive,
                                  std::size_t texCoord, const glm::dmat4& worldFromNode);

// gltf_nodes.cpp
struct GltfNode {
    std::size_t index = 0;
    glm::dmat4 worldFromNode{1.0};
};
// The nodes of the file's scene, parents first. Throws Error for cycles and shared children.
std::vector<GltfNode> readNodes(const GltfFile& file);

// gltf_views.cpp: what nodes carry besides meshes. `box` bounds the scene's triangles.
std::optional<Camera> readCamera(const GltfFile& file, const GltfNode& node, const Box& box);
std::optional<Light> readLight(const GltfFile& file, const GltfNode& node, const Box& box);

}  // namespace penumbra
