#include "metamorphic/transforms.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "scene/shapes.h"

namespace penumbra {

namespace {

glm::vec3 onGrid(glm::vec3 p) { return glm::round(p * 1024.0f) / 1024.0f; }

template <typename Map>
void forEachPoint(Scene& scene, const Map& map) {
    for (Mesh& mesh : scene.meshes)
        for (glm::vec3& p : mesh.positions) p = map(p);
    for (Light& light : scene.lights) light.center = map(light.center);
    scene.camera.eye = map(scene.camera.eye);
    scene.camera.target = map(scene.camera.target);
}

}  // namespace

Scene onGrid(Scene scene) {
    forEachPoint(scene, [](glm::vec3 p) { return onGrid(p); });
    return scene;
}

Scene moved(Scene scene, glm::vec3 by) {
    forEachPoint(scene, [&](glm::vec3 p) { return p + by; });
    return scene;
}

Scene turned(Scene scene, const glm::dmat3& rotation) {
    const auto turn = [&](glm::vec3 v) { return glm::vec3(rotation * glm::dvec3(v)); };
    forEachPoint(scene, turn);
    for (Mesh& mesh : scene.meshes)
        for (glm::vec3& n : mesh.normals) n = turn(n);
    for (Light& light : scene.lights) light.right = turn(light.right), light.up = turn(light.up);
    scene.camera.up = turn(scene.camera.up);
    return scene;
}

glm::dmat3 quarterTurns(int count) {
    glm::dmat3 result(1.0);
    for (int i = 0; i < count; ++i) result = glm::dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0) * result;
    return result;
}

glm::dmat3 obliqueTurn() {
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(37.0), glm::dvec3(1, 2, 3)));
}

Scene reversed(Scene scene) {
    std::reverse(scene.meshes.begin(), scene.meshes.end());
    for (Mesh& mesh : scene.meshes) std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    return scene;
}

Scene merged(Scene scene) {
    for (std::size_t i = 1; i < scene.meshes.size(); ++i) append(scene.meshes[0], scene.meshes[i]);
    scene.meshes.resize(1);
    return scene;
}

Scene withSlab(Scene scene, const Box& slab) {
    scene.meshes.push_back(box(slab.lower, slab.upper, 0));
    scene.meshes.back().name = "slab";
    return scene;
}

Scene withSpecks(Scene scene, const Box& slab) {
    const glm::vec3 side = (slab.upper - slab.lower) / 1024.0f;
    Mesh specks;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 at(i & 1, i >> 1 & 1, i >> 2);
        const glm::vec3 lower = glm::mix(slab.lower, slab.upper - side, at);
        const glm::vec3 upper = glm::mix(slab.lower + side, slab.upper, at);
        if (i == 0)
            specks = box(lower, upper, 0);
        else
            append(specks, box(lower, upper, 0));
    }
    specks.name = "slab";
    scene.meshes.push_back(std::move(specks));
    return scene;
}

Box slabBeforeTheLight(const Scene& scene) {
    const Light& light = scene.lights[0];
    const glm::vec3 middle = bounds(scene).center();
    const glm::vec3 half(0.5f * light.width, 0.03125f, 0.5f * light.width);
    const glm::mat4 clipFromWorld = scene.camera.clipFromView(1) * scene.camera.viewFromWorld();
    const auto inView = [&](glm::vec3 p) {
        const glm::vec4 clip = clipFromWorld * glm::vec4(p, 1.0f);
        return std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) < clip.w;
    };
    for (float way = 0.4f; way < 0.75f; way += 0.05f) {
        const glm::vec3 at = onGrid(glm::mix(middle, light.center, way));
        int corners = 0;
        for (int i = 0; i < 8; ++i)
            corners += inView(at + half * (2.0f * glm::vec3(i & 1, i >> 1 & 1, i >> 2) - 1.0f));
        if (corners == 0 || corners == 8) return {at - half, at + half};
    }
    throw Error("no place for a slab before the light", scene.name, "take another scene");
}

Scene twoBoxes() {
    Scene scene;
    scene.name = "two boxes";
    scene.materials.push_back({.name = "grey"});
    scene.meshes.push_back(ground(16, 1, 0));
    scene.meshes.back().name = "ground";
    for (const float x : {-3.5f, 3.5f}) {
        scene.meshes.push_back(box({x - 0.45f, 0, -0.55f}, {x + 0.45f, 1.7f, 0.6f}, 0));
        scene.meshes.back().name = x < 0 ? "left box" : "right box";
    }
    scene.camera = {.eye = {0.4f, 7.0f, 8.5f}, .target = {0, 0, 0}, .farPlane = 40};
    scene.lights = {Light::lookingAt({0.7f, 9, -1.5f}, {0, 0, 0}, 0.5f)};
    return scene;
}

Box lowBox() { return {{-0.4f, 0, -0.3f}, {0.5f, 0.8f, 0.4f}}; }

Scene sheetScene(int steps) {
    Scene scene;
    scene.name = "sheet";
    scene.materials.push_back({.name = "grey"});
    scene.meshes.push_back(ground(40, 1, 0));
    scene.meshes.back().name = "ground";
    // Its shadow is twice as large and moves twice as far: 0.65625 = 4 pixels of 10.5 / 64.
    const float by = float(steps) * 0.328125f;
    const float left = 0.11f - by, front = -0.53f - by, y = 4;
    scene.meshes.push_back(quad({left, y, front}, {left, y, front + 0.9f},
                                {left + 1, y, front + 0.9f}, {left + 1, y, front}, 0));
    scene.meshes.back().name = "sheet";
    scene.camera = {.eye = {-2, 6, 0},
                    .target = {-2, 0, 0},
                    .up = {0, 0, -1},
                    .verticalFov = 2 * std::atan(0.875f),
                    .nearPlane = 0.5f,
                    .farPlane = 20};
    Light light{.center = {0, 8, 0}, .width = 1.5f};
    scene.lights = {light};
    return scene;
}

}  // namespace penumbra
