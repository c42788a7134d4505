// Scenes whose visibility is known in closed form at every point of the ground.
//
// halfplane, seen along z:
//
//   H  --------====--------  light, L wide     A receiver at x sees the blocker's edge projected to
//              /  \                            -x (H - h) / h on the light's plane; the light left
//   h  ________/    \        blocker: x < 0    of that is hidden:
//             /      \                           V = clamp(1/2 + x (H - h) / (h L), 0, 1),
//   0  ------+--------+----  receiver           a penumbra L h / (H - h) wide.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/gallery.h"
#include "scene/gallery_scenes.h"
#include "scene/random.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

// Faces straight down from (0, height, 0), edges along x and z.
Light overheadLight(float height, float width) {
    Light light;
    light.center = {0.0f, height, 0.0f};
    light.right = {1.0f, 0.0f, 0.0f};
    light.up = {0.0f, 0.0f, -1.0f};
    light.width = width;
    return light;
}

Scene bareScene() {
    Scene scene;
    scene.materials = {{.name = "ground", .baseColor = {0.55f, 0.53f, 0.50f}},
                       {.name = "blocker", .baseColor = {0.28f, 0.33f, 0.40f}}};
    return scene;
}

}  // namespace

Scene halfPlaneScene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = bareScene();
    scene.meshes.push_back(ground(12.0f, 1, 0));
    // Far larger than what light and visible receivers span, so that only the edge x = 0 counts.
    constexpr float h = kHalfPlaneBlockerHeight, kReach = 12.0f;
    scene.meshes.push_back(
        quad({-kReach, h, -kReach}, {-kReach, h, kReach}, {0, h, kReach}, {0, h, -kReach}, 1));
    scene.meshes.back().name = "blocker";
    scene.lights = {overheadLight(kHalfPlaneLightHeight, kHalfPlaneLightWidth)};
    // Below the blocker's plane, so that it hides nothing. Only the view varies with the seed.
    const float slide = random.between(-0.6f, 0.6f), side = random.between(1.2f, 1.8f);
    scene.camera = {.eye = {seed == 1 ? 1.5f : side, 3.4f, seed == 1 ? 0.6f : slide},
                    .target = {0.0f, 0.0f, seed == 1 ? 0.0f : 0.5f * slide},
                    .verticalFov = 0.6f};
    fitDepthRange(scene);
    return scene;
}

std::vector<glm::vec3> polygonSceneVertices(std::uint64_t seed) {
    Random random(seed ^ 0x9017ull);
    const int count = 5 + int(random.bits() % 3);
    const glm::vec2 center(random.between(-0.4f, 0.4f), random.between(-0.4f, 0.4f));
    const glm::vec2 radii(random.between(0.9f, 1.4f), random.between(0.9f, 1.4f));
    const float height = random.between(2.0f, 3.2f);
    const glm::vec2 slope(random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f));
    const float start = random.between(0.0f, glm::two_pi<float>());
    std::vector<glm::vec3> vertices;
    for (int i = 0; i < count; ++i) {
        // On an ellipse, hence convex; jittered by less than half a step, hence in order.
        const float step = float(i) + random.between(-0.3f, 0.3f);
        const float angle = start + glm::two_pi<float>() * step / float(count);
        const glm::vec2 offset(radii.x * std::cos(angle), radii.y * std::sin(angle));
        vertices.emplace_back(center.x + offset.x, height + glm::dot(slope, offset),
                              center.y + offset.y);
    }
    return vertices;
}

Scene polygonScene(std::uint64_t seed) {
    Scene scene = bareScene();
    scene.meshes.push_back(ground(12.0f, 1, 0));
    const auto vertices = polygonSceneVertices(seed);
    Mesh blocker;
    blocker.name = "blocker";
    blocker.material = 1;
    const glm::vec3 normal =
        glm::normalize(glm::cross(vertices[2] - vertices[0], vertices[1] - vertices[0]));
    for (const glm::vec3 v : vertices) {
        blocker.positions.push_back(v);
        blocker.normals.push_back(normal);  // up
    }
    for (unsigned i = 2; i < vertices.size(); ++i) blocker.triangles.emplace_back(0u, i, i - 1);
    scene.meshes.push_back(std::move(blocker));
    scene.lights = {overheadLight(kPolygonLightHeight, kPolygonLightWidth)};
    scene.camera = {.eye = {2.6f, 4.8f, 4.6f}, .target = {-0.1f, 0.0f, 0.1f}, .verticalFov = 0.75f};
    fitDepthRange(scene);
    return scene;
}

Scene tiltedScene(double incidenceDegrees) {
    const double incidence = glm::radians(incidenceDegrees);
    Scene scene = bareScene();
    scene.meshes.push_back(ground(6.0f, 1, 0));
    scene.lights = {standardLight(0.3f, float(incidence))};
    // At grazing incidence a full-size light would dip below the plane and V = 1 would be wrong:
    // shrink it so that its lowest edge stays at a tenth of the centre's height or more.
    const double room = 0.9 * kStandardLightDistance * std::cos(incidence) / std::sin(incidence);
    if (incidence > 0.0) scene.lights[0].width = std::min(kStandardLightWidth, float(2.0 * room));
    scene.camera = {.eye = {0.0f, 7.0f, 0.0f},
                    .target = {0.0f, 0.0f, 0.0f},
                    .up = {0.0f, 0.0f, -1.0f},
                    .verticalFov = 0.76f};
    fitDepthRange(scene);
    return scene;
}

}  // namespace penumbra
