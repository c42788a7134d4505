#include "scene/scene.h"

namespace penumbra {

Box bounds(const Mesh& mesh) {
    Box box;
    for (const glm::vec3 p : mesh.positions) box.include(p);
    return box;
}

Box bounds(std::span<const Mesh> meshes) {
    Box box;
    for (const Mesh& mesh : meshes)
        for (const glm::vec3 p : mesh.positions) box.include(p);
    return box;
}

Box bounds(const Scene& scene) { return bounds(std::span(scene.meshes)); }

std::size_t triangleCount(const Scene& scene) {
    std::size_t count = 0;
    for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
    return count;
}

Scene scaled(Scene scene, float factor) {
    for (Mesh& mesh : scene.meshes)
        for (glm::vec3& p : mesh.positions) p *= factor;
    for (Light& light : scene.lights)
        light.center *= factor, light.width *= factor, light.range *= factor;
    Camera& camera = scene.camera;
    camera.eye *= factor, camera.target *= factor;
    camera.nearPlane *= factor, camera.farPlane *= factor;
    return scene;
}

}  // namespace penumbra
