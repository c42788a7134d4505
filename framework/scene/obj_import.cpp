#include "scene/obj_import.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>

#include "core/error.h"
#include "scene/texture_file.h"

namespace penumbra {

namespace {

Texture2D loadTexture(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error("no such texture", path.string(), "unpack the whole model folder");
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    return decodeTexture({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                         path.string());
}

bool hasHoles(const Texture2D& texture) {
    for (std::size_t i = 3; i < texture.rgba.size(); i += 4)
        if (texture.rgba[i] < 128) return true;
    return false;
}

// A map_d of its own: its alpha where it has any, else its grey.
void takeAlpha(Texture2D& color, const Texture2D& alpha) {
    const bool grey = !hasHoles(alpha);
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x) {
            const std::size_t from =
                4 * (std::size_t(y * alpha.height / color.height) * std::size_t(alpha.width) +
                     std::size_t(x * alpha.width / color.width));
            const std::size_t to = 4 * (std::size_t(y) * std::size_t(color.width) + std::size_t(x));
            color.rgba[to + 3] = alpha.rgba[from + (grey ? 0 : 3)];
        }
}

float linear(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

class ObjImporter {
public:
    explicit ObjImporter(const std::filesystem::path& path) : folder_(path.parent_path()) {
        tinyobj::ObjReaderConfig config;
        config.vertex_color = false;
        if (!reader_.ParseFromFile(path.string(), config))
            throw Error("cannot read OBJ", path.string(), reader_.Error() + "check the file");
        scene_.name = path.stem().string();
        for (const auto& material : reader_.GetMaterials()) addMaterial(material);
        scene_.materials.push_back({.name = "default"});
        scene_.meshes.resize(scene_.materials.size());
        known_.resize(scene_.materials.size());
        for (const auto& shape : reader_.GetShapes()) addShape(shape.mesh);
        finish();
        if (scene_.meshes.empty()) throw Error("model has no triangles", path.string(), "skip it");
    }
    Scene take() { return std::move(scene_); }

private:
    using Key = std::array<int, 3>;

    void addMaterial(const tinyobj::material_t& from) {
        Material material;
        material.name = from.name;
        material.baseColor = {linear(from.diffuse[0]), linear(from.diffuse[1]),
                              linear(from.diffuse[2])};
        left_.push_back(from.diffuse_texname.empty() && from.dissolve < 0.5f);
        if (!from.diffuse_texname.empty()) {
            material.texture = textureIndex(from.diffuse_texname, from.alpha_texname);
            material.baseColor = glm::vec3(1.0f);  // these exporters' Kd does not belong to the map
            if (hasHoles(scene_.textures[std::size_t(material.texture)]))
                material.alphaCutoff = 0.5f;
        }
        scene_.materials.push_back(material);
    }

    int textureIndex(const std::string& color, const std::string& alpha) {
        const auto [known, isNew] = textures_.try_emplace(color + "|" + alpha, 0);
        if (!isNew) return known->second;
        Texture2D texture = loadTexture(folder_ / color);
        if (!alpha.empty() && alpha != color) takeAlpha(texture, loadTexture(folder_ / alpha));
        scene_.textures.push_back(std::move(texture));
        return known->second = int(scene_.textures.size()) - 1;
    }

    void addShape(const tinyobj::mesh_t& mesh) {
        for (std::size_t face = 0; face < mesh.num_face_vertices.size(); ++face) {
            if (mesh.num_face_vertices[face] != 3) continue;  // triangulated: points and lines
            const int given = mesh.material_ids[face];
            const bool none = given < 0 || std::size_t(given) >= left_.size();
            if (!none && left_[std::size_t(given)]) continue;
            addTriangle(&mesh.indices[3 * face], none ? left_.size() : std::size_t(given));
        }
    }

    glm::vec3 position(int vertex) const {
        const auto& v = reader_.GetAttrib().vertices;
        const auto i = 3 * std::size_t(vertex);
        if (vertex < 0 || i + 2 >= v.size()) throw Error("broken OBJ", scene_.name, "bad vertex");
        return {v[i], v[i + 1], v[i + 2]};
    }

    void addTriangle(const tinyobj::index_t* corners, std::size_t material) {
        const glm::vec3 a = position(corners[0].vertex_index),
                        b = position(corners[1].vertex_index),
                        c = position(corners[2].vertex_index);
        const glm::dvec3 twiceArea = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
        if (!(glm::length(twiceArea) > 0.0)) return;
        const glm::vec3 facet = glm::vec3(glm::normalize(twiceArea));
        glm::uvec3 triangle;
        for (int k = 0; k < 3; ++k) triangle[k] = vertex(corners[k], material, facet);
        scene_.meshes[material].triangles.push_back(triangle);
    }

    unsigned vertex(const tinyobj::index_t& corner, std::size_t material, glm::vec3 facet) {
        Mesh& mesh = scene_.meshes[material];
        const auto next = unsigned(mesh.positions.size());
        if (corner.normal_index >= 0) {  // without a normal every facet has its own, flat vertices
            const Key key = {corner.vertex_index, corner.normal_index, corner.texcoord_index};
            const auto [known, isNew] = known_[material].try_emplace(key, next);
            if (!isNew) return known->second;
        }
        const auto& attributes = reader_.GetAttrib();
        mesh.positions.push_back(position(corner.vertex_index));
        glm::vec3 normal = facet;
        if (corner.normal_index >= 0) {
            const float* n = &attributes.normals.at(3 * std::size_t(corner.normal_index) + 2) - 2;
            if (const glm::vec3 given(n[0], n[1], n[2]); glm::length(given) > 1e-6f)
                normal = glm::normalize(given);
        }
        mesh.normals.push_back(normal);
        glm::vec2 uv(0.0f);
        if (corner.texcoord_index >= 0) {
            const auto i = 2 * std::size_t(corner.texcoord_index);
            uv = {attributes.texcoords.at(i),
                  1.0f - attributes.texcoords.at(i + 1)};  // v downwards
        }
        mesh.uvs.push_back(uv);
        return next;
    }

    void finish() {
        for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
            scene_.meshes[i].name = scene_.materials[i].name;
            scene_.meshes[i].material = int(i);
            if (scene_.materials[i].texture < 0) scene_.meshes[i].uvs.clear();
        }
        std::erase_if(scene_.meshes, [](const Mesh& mesh) { return mesh.triangles.empty(); });
    }

    std::filesystem::path folder_;
    tinyobj::ObjReader reader_;
    Scene scene_;
    std::vector<bool> left_;  // by material: out
    std::map<std::string, int> textures_;
    std::vector<std::map<Key, unsigned>> known_;  // by material
};

}  // namespace

Scene importObj(const std::filesystem::path& path) {
    try {
        return ObjImporter(path).take();
    } catch (const std::out_of_range&) {
        throw Error("broken OBJ", path.string(), "an index has no vertex");
    }
}

}  // namespace penumbra
