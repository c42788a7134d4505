#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "scene/gltf.h"
#include "scene/texture_file.h"

namespace penumbra {

namespace {

using json = nlohmann::json;  // a map: references to members stay valid when others are added

json array(glm::vec3 v) { return {double(v.x), double(v.y), double(v.z)}; }

// Column by column; doubles print so that every float comes back bit for bit.
json matrix(glm::dvec3 x, glm::dvec3 y, glm::dvec3 z, glm::dvec3 origin) {
    return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, origin.x, origin.y, origin.z, 1};
}

// glTF wants colours up to 1; a power of two as scale keeps their product exact.
std::pair<glm::vec3, double> factorAndScale(glm::vec3 color) {
    double scale = 1.0;
    while (std::max({color.x, color.y, color.z}) > scale) scale *= 2.0;
    return {color / float(scale), scale};
}

class GlbWriter {
public:
    explicit GlbWriter(const Scene& scene) : scene_(scene) {
        root_["asset"] = {{"version", "2.0"}, {"generator", "Penumbra"}};
        root_["scene"] = 0;
        root_["scenes"] = {{{"name", scene.name}, {"nodes", json::array()}}};
        for (const Texture2D& texture : scene.textures) addTexture(texture);
        for (const Material& material : scene.materials) addMaterial(material);
        for (const Mesh& mesh : scene.meshes)
            if (!mesh.triangles.empty()) addMesh(mesh);  // glTF knows no empty accessors
        addCamera(scene.camera);
        for (const Light& light : scene.lights) addLight(light);
    }

    std::vector<std::uint8_t> bytes() {
        if (!binary_.empty()) root_["buffers"] = {{{"byteLength", binary_.size()}}};
        std::string text = root_.dump(-1, ' ', false, json::error_handler_t::replace);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary_.resize((binary_.size() + 3) / 4 * 4, 0);
        std::vector<std::uint8_t> out;
        const auto word = [&](std::size_t value) {
            for (int shift = 0; shift < 32; shift += 8) out.push_back(std::uint8_t(value >> shift));
        };
        word(0x46546c67), word(2);  // "glTF"
        word(12 + 8 + text.size() + 8 + binary_.size());
        word(text.size()), word(0x4e4f534a);  // "JSON"
        out.insert(out.end(), text.begin(), text.end());
        word(binary_.size()), word(0x004e4942);  // "BIN"
        out.insert(out.end(), binary_.begin(), binary_.end());
        return out;
    }

private:
    std::size_t addView(const void* data, std::size_t size) {
        binary_.resize((binary_.size() + 3) / 4 * 4, 0);
        const std::size_t offset = binary_.size();
        binary_.resize(offset + size);
        std::memcpy(binary_.data() + offset, data, size);
        json& views = root_["bufferViews"];
        views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
        return views.size() - 1;
    }

    template <typename T>
    std::size_t addAccessor(const std::vector<T>& values, const char* type, int componentType,
                            std::size_t count) {
        json& accessors = root_["accessors"];
        accessors.push_back({{"bufferView", addView(values.data(), values.size() * sizeof(T))},
                             {"componentType", componentType},
                             {"count", count},
                             {"type", type}});
        return accessors.size() - 1;
    }

    void addNode(json node) {
        json& nodes = root_["nodes"];
        root_["scenes"][0]["nodes"].push_back(nodes.size());
        nodes.push_back(std::move(node));
    }

    void use(const char* extension) {
        json& used = root_["extensionsUsed"];
        if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
    }

    void addTexture(const Texture2D& texture) {
        const auto png = encodeTexture(texture);
        root_["images"].push_back(
            {{"bufferView", addView(png.data(), png.size())}, {"mimeType", "image/png"}});
        root_["textures"].push_back({{"source", root_["images"].size() - 1}});
    }

    void addMaterial(const Material& material) {
        const glm::vec3 c = material.baseColor;
        json pbr = {{"baseColorFactor", {double(c.x), double(c.y), double(c.z), 1.0}},
                    {"metallicFactor", 0},
                    {"roughnessFactor", 1}};
        if (material.texture >= 0) pbr["baseColorTexture"] = {{"index", material.texture}};
        json out = {{"name", material.name}, {"pbrMetallicRoughness", pbr}, {"doubleSided", true}};
        if (material.alphaCutoff > 0.0f) {
            out["alphaMode"] = "MASK";
            out["alphaCutoff"] = double(material.alphaCutoff);
        }
        if (material.emissive != glm::vec3(0.0f)) {
            const auto [factor, strength] = factorAndScale(material.emissive);
            out["emissiveFactor"] = array(factor);
            if (strength != 1.0) {
                out["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
                use("KHR_materials_emissive_strength");
            }
        }
        root_["materials"].push_back(std::move(out));
    }

    void addMesh(const Mesh& mesh) {
        constexpr int kFloat = 5126, kUnsignedInt = 5125;
        const std::size_t count = mesh.positions.size();
        EXPECTS(mesh.normals.size() == count && (mesh.uvs.empty() || mesh.uvs.size() == count));
        json attributes;
        attributes["POSITION"] = addAccessor(mesh.positions, "VEC3", kFloat, count);
        const Box box = bounds(mesh);
        root_["accessors"].back()["min"] = array(box.lower);
        root_["accessors"].back()["max"] = array(box.upper);
        attributes["NORMAL"] = addAccessor(mesh.normals, "VEC3", kFloat, count);
        if (!mesh.uvs.empty())
            attributes["TEXCOORD_0"] = addAccessor(mesh.uvs, "VEC2", kFloat, count);
        json primitive = {{"attributes", attributes},
                          {"indices", addAccessor(mesh.triangles, "SCALAR", kUnsignedInt,
                                                  3 * mesh.triangles.size())}};
        if (!scene_.materials.empty()) primitive["material"] = mesh.material;
        root_["meshes"].push_back({{"name", mesh.name}, {"primitives", {primitive}}});
        addNode({{"name", mesh.name}, {"mesh", root_["meshes"].size() - 1}});
    }

    void addCamera(const Camera& camera) {
        const glm::dvec3 backward =
            glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), backward));
        root_["cameras"].push_back({{"type", "perspective"},
                                    {"perspective",
                                     {{"yfov", double(camera.verticalFov)},
                                      {"znear", double(camera.nearPlane)},
                                      {"zfar", double(camera.farPlane)}}}});
        addNode({{"name", "camera"},
                 {"camera", 0},
                 {"matrix", matrix(right, glm::cross(backward, right), backward, camera.eye)}});
    }

    // A square is a spot, since it has a direction; cones as wide as glTF allows, a square's half
    // space.
    void addLight(const Light& light) {
        const auto [color, intensity] = factorAndScale(light.color);
        json out = {{"color", array(color)},
                    {"intensity", intensity},
                    {"extras", {{"width", double(light.width)}}}};
        out["type"] = light.directional ? "directional" : "spot";
        if (!light.directional) {
            out["spot"] = {{"outerConeAngle", 1.5707963}};
            if (std::isfinite(light.range)) out["range"] = double(light.range);
        }
        json& lights = root_["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back(std::move(out));
        use("KHR_lights_punctual");
        const glm::dvec3 backward = glm::cross(glm::dvec3(light.right), glm::dvec3(light.up));
        addNode({{"name", "light"},
                 {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}},
                 {"matrix", matrix(light.right, light.up, backward, light.center)}});
    }

    const Scene& scene_;
    json root_;
    std::vector<std::uint8_t> binary_;
};

}  // namespace

void saveGlb(const std::filesystem::path& path, const Scene& scene) {
    const auto bytes = GlbWriter(scene).bytes();
    if (bytes.size() > 0xffffffffu)
        throw Error("scene is too large", path.string(), "a .glb holds up to 4 GiB");
    // A reader never sees half a file.
    const auto part = std::filesystem::path(path).concat(".part");
    std::ofstream file(part, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    file.close();
    std::error_code error;
    if (file) std::filesystem::rename(part, path, error);
    if (!file || error) {
        std::filesystem::remove(part, error);
        throw Error("cannot write model", path.string(), "check that the folder is writable");
    }
}

}  // namespace penumbra
