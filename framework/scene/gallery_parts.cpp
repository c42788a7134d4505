#include "scene/gallery_parts.h"

#include <cmath>

namespace penumbra {

Scene emptyScene() {
    Scene scene;
    scene.materials.push_back({.name = "ground", .baseColor = {0.55f, 0.53f, 0.50f}});
    scene.camera = {.eye = {2.4f, 7.9f, 8.2f}, .target = {0.4f, 0.3f, 0.2f}, .verticalFov = 0.70f};
    return scene;
}

int addMaterial(Scene& scene, const char* name, glm::vec3 color, glm::vec3 emissive) {
    scene.materials.push_back({.name = name, .baseColor = color, .emissive = emissive});
    return int(scene.materials.size()) - 1;
}

void add(Scene& scene, const char* name, Mesh mesh) {
    mesh.name = name;
    scene.meshes.push_back(std::move(mesh));
}

Mesh turned(Mesh mesh, glm::vec3 pivot, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    const glm::mat3 rotation(c, 0, -s, 0, 1, 0, s, 0, c);
    for (glm::vec3& p : mesh.positions) p = pivot + rotation * (p - pivot);
    for (glm::vec3& n : mesh.normals) n = rotation * n;
    return mesh;
}

Mesh moved(Mesh mesh, glm::vec3 by) {
    for (glm::vec3& p : mesh.positions) p += by;
    return mesh;
}

}  // namespace penumbra
