#include "scene/gltf.h"

#include <fmt/format.h>

#include "core/error.h"
#include "scene/gltf_parts.h"

namespace penumbra {

namespace {

// One mesh may hang on many nodes: a small file can ask for any amount of memory.
constexpr std::size_t kMostTriangles = std::size_t(1) << 25;

class MeshReader {
public:
    MeshReader(const GltfFile& file, Scene& scene) : file_(file), scene_(scene) {
        materials_ = readMaterials(file);
        scene.materials = std::move(materials_.materials);
        scene.textures = std::move(materials_.textures);
    }

    void read(const GltfNode& node) {
        const GltfValue value = file_.item("nodes", node.index);
        const auto reference = value.find("mesh");
        if (!reference) return;
        const GltfValue meshes = file_.list("meshes");
        const GltfValue mesh = meshes.item(reference->index(meshes.size()));
        const GltfValue primitives = mesh.at("primitives");
        for (std::size_t i = 0; i < primitives.size(); ++i)
            readOne(primitives.item(i), node, mesh.textOr("name", value.textOr("name", "mesh")));
    }

private:
    void readOne(const GltfValue& primitive, const GltfNode& node, const std::string& name) {
        const auto given = primitive.find("material");
        const std::size_t known = materials_.texCoord.size();
        if (given) given->index(known);
        const std::size_t material = given ? given->whole() : known;
        auto mesh = readPrimitive(file_, primitive, given ? materials_.texCoord[material] : 0,
                                  node.worldFromNode);
        if (!mesh || (given && materials_.invisible[material])) return;
        if (!given && scene_.materials.size() == known)
            scene_.materials.push_back({.name = "default", .baseColor = glm::vec3(1.0f)});
        mesh->name = name;
        mesh->material = int(material);
        // A texture without coordinates shows its first texel, as GPUs do with a missing attribute.
        if (mesh->uvs.empty() && scene_.materials[material].texture >= 0)
            mesh->uvs.assign(mesh->positions.size(), glm::vec2(0.0f));
        total_ += mesh->triangles.size() + mesh->positions.size() / 3;
        if (total_ > kMostTriangles) primitive.fail("exceeds 33 million triangles", "use less");
        scene_.meshes.push_back(std::move(*mesh));
    }

    const GltfFile& file_;
    Scene& scene_;
    GltfMaterials materials_;
    std::size_t total_ = 0;
};

}  // namespace

Scene loadGltf(const std::filesystem::path& path) {
    const GltfFile file = openGltf(path);
    const std::vector<GltfNode> nodes = readNodes(file);
    Scene scene;
    scene.name = path.stem().string();
    MeshReader meshes(file, scene);
    for (const GltfNode& node : nodes) meshes.read(node);
    if (triangleCount(scene) == 0)
        throw Error("model has no triangles", path.string(), "export a mesh with it");

    const Box box = bounds(scene);
    bool hasCamera = false;
    for (const GltfNode& node : nodes) {
        if (const auto light = readLight(file, node, box)) scene.lights.push_back(*light);
        const auto camera = readCamera(file, node, box);
        if (!camera || hasCamera) continue;  // the first one counts, every one is checked
        scene.camera = *camera;
        hasCamera = true;
    }
    if (!hasCamera) scene.camera = sensibleCamera(box);
    if (scene.lights.empty()) scene.lights.push_back(sensibleLight(box));
    return scene;
}

}  // namespace penumbra
