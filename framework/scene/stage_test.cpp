#include "scene/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/gallery.h"
#include "scene/shapes.h"

namespace penumbra {
namespace {

void expectInView(const Camera& camera, const std::vector<glm::vec3>& points) {
    const glm::mat4 clipFromWorld = camera.clipFromView(1.0f) * camera.viewFromWorld();
    for (const glm::vec3 p : points) {
        const glm::vec4 clip = clipFromWorld * glm::vec4(p, 1.0f);
        for (int k = 0; k < 3; ++k)
            EXPECT_LT(std::abs(clip[k]), clip.w) << p.x << " " << p.y << " " << p.z;
    }
}

// All but the ground, which stageModel() adds last.
Box modelBox(const Scene& scene) {
    Box box;
    for (std::size_t i = 0; i + 1 < scene.meshes.size(); ++i) {
        const Box part = bounds(scene.meshes[i]);
        box.include(part.lower), box.include(part.upper);
    }
    return box;
}

void expectWellStaged(const Scene& scene) {
    SCOPED_TRACE(scene.name);
    ASSERT_EQ(scene.meshes.back().name, "ground");
    const Box box = modelBox(scene);
    const glm::vec3 size = box.upper - box.lower;
    EXPECT_GE(box.lower.y, -1e-4f);
    EXPECT_GE(std::max({size.x, size.y, size.z}), 1.0f);
    EXPECT_LE(std::max({size.x, size.y, size.z}), 4.001f);
    Scene model = scene;
    model.meshes.pop_back();
    const auto shadow = shadowOnGround(vertices(model), scene.lights.at(0));
    expectInView(scene.camera, corners(box));
    expectInView(scene.camera, shadow);
    const Box ground = bounds(scene.meshes.back());
    EXPECT_GE(ground.upper.x - ground.lower.x, 12.0f);
    EXPECT_LT(ground.upper.x - ground.lower.x, 16.0f);
    for (const glm::vec3 p : shadow) {
        ASSERT_GT(std::min(p.x - ground.lower.x, ground.upper.x - p.x), 0.0f);
        ASSERT_GT(std::min(p.z - ground.lower.z, ground.upper.z - p.z), 0.0f);
    }
    for (const Mesh& mesh : scene.meshes)
        for (const glm::vec3 n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-4f);
}

TEST(Stage, ModelsOfAnyUnitRestOnTheGroundInView) {
    for (const float unit : {1e-3f, 1.0f, 100.0f})
        for (const Stage stage : {Stage{}, Stage{.size = 4.0f, .turnDegrees = 30.0f},
                                  Stage{.size = 2.0f, .lift = 1.0f}}) {
            Scene scene;
            scene.materials.resize(1);
            scene.meshes = {box(unit * glm::vec3(5, 7, 9), unit * glm::vec3(6, 10, 11), 0)};
            stageModel(scene, stage);
            EXPECT_NEAR(modelBox(scene).lower.y, stage.lift, 1e-4f);
            expectWellStaged(scene);
        }
}

TEST(Stage, TurnIsCounterClockwiseSeenFromAbove) {
    Scene scene;
    scene.materials.resize(1);
    scene.meshes = {box({0, 0, 0}, {4, 1, 1}, 0)};
    stageModel(scene, {.size = 4.0f, .turnDegrees = 90.0f});
    const Box turned = modelBox(scene);
    EXPECT_NEAR(turned.upper.z - turned.lower.z, 4.0f, 1e-4f);
    EXPECT_NEAR(turned.upper.x - turned.lower.x, 1.0f, 1e-4f);
}

TEST(CameraShowing, TouchesTheMarginOnOneAxis) {
    const std::vector<glm::vec3> points = {{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
    const Camera camera = cameraShowing(points, glm::normalize(glm::vec3(0, -1, -1)), 0.6f);
    const glm::mat4 clipFromWorld = camera.clipFromView(1.0f) * camera.viewFromWorld();
    float widest = 0.0f;
    for (const glm::vec3 p : points) {
        const glm::vec4 clip = clipFromWorld * glm::vec4(p, 1.0f);
        widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
    }
    EXPECT_NEAR(widest, 0.9f, 1e-3f);
}

TEST(InstalledModels, AreFullyInViewWithTheirShadows) {
    const auto names = installedModelNames();
    std::ifstream file(repositoryRoot() / "framework/scene/models.json");
    const auto manifest = nlohmann::json::parse(file);
    int seen = 0;
    for (const auto& model : manifest.at("models")) {
        const std::string name = model.at("name");
        for (const std::string& builtIn : builtInSceneNames()) EXPECT_NE(name, builtIn);
        if (std::find(names.begin(), names.end(), name) == names.end()) continue;
        expectWellStaged(loadScene(name));
        ++seen;
    }
    if (seen == 0) GTEST_SKIP() << "no models installed: framework/scene/install_models.sh";
}

}  // namespace
}  // namespace penumbra
