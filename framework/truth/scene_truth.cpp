#include "truth/scene_truth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "truth/closed_form.h"

namespace penumbra {

std::optional<Image> exactVisibility(const Scene& scene, const Receivers& receivers) {
    const std::string maker = scene.name.substr(0, scene.name.find('@'));
    const std::array exact{"halfplane", "polygon", "tilted"};
    if (std::find(exact.begin(), exact.end(), maker) == exact.end() || scene.lights[0].directional)
        return std::nullopt;
    std::vector<glm::dvec3> blocker;  // corners in order around it: see gallery_exact.cpp
    for (const Mesh& mesh : scene.meshes)
        if (mesh.name == "blocker") blocker.assign(mesh.positions.begin(), mesh.positions.end());
    glm::dvec3 normal(0);
    if (!blocker.empty())
        normal = glm::normalize(glm::cross(blocker[1] - blocker[0], blocker[2] - blocker[0]));
    Image image(receivers.width, receivers.height, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (!receivers.hit[i]) {
            image.pixels[i] = 1;
            continue;
        }
        const glm::dvec3 p = receivers.positions[i];
        double visibility = horizonVisibility(p, receivers.facetNormals[i], scene.lights[0]);
        // A receiver on the blocker itself has nothing but its horizon; traced points lie within
        // float32 rounding of its plane, the ground is units away.
        if (!blocker.empty() && std::abs(glm::dot(normal, p - blocker[0])) > 1e-4)
            visibility = std::min(visibility, polygonVisibility(p, blocker, scene.lights[0]));
        image.pixels[i] = float(visibility);
    }
    return image;
}

}  // namespace penumbra
