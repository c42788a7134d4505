#include "scene/gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/error.h"
#include "scene/gallery.h"
#include "scene/scratch_folder.h"
#include "scene/shapes.h"

namespace penumbra {
namespace {

std::filesystem::path scratch(const std::string& name) {
    static const ScratchFolder folder;
    return folder / name;
}

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

Scene fullScene() {
    Scene scene = loadScene("stairs@3");
    scene.textures.push_back({2, 3, std::vector<std::uint8_t>(24)});
    for (std::size_t i = 0; i < 24; ++i) scene.textures[0].rgba[i] = std::uint8_t(i * 37 + 5);
    scene.textures.push_back({1, 1, {1, 2, 3, 0}});
    scene.materials[1].texture = 1;
    scene.materials[2].texture = 0;
    scene.materials[2].alphaCutoff = 0.3f;
    scene.materials[2].baseColor = {0.1f, 1.0f / 3.0f, 0.7f};
    scene.lights.push_back(Light::lookingAt({1, 7, -3}, {0.3f, 0, 0.1f}, 0.77f));
    scene.lights[1].color = {0.1f, 3.7f, 1.0f / 3.0f};
    scene.lights[1].range = 1.0f / 0.7f;
    scene.lights.push_back(Light::lookingAt({9, 27, -13}, {0.3f, 0, 0.1f}, 0.77f));
    scene.lights[2].directional = true;
    scene.materials[1].emissive = {0.3f, 1.0f / 3.0f, 0};
    scene.materials[2].emissive = {7.1f, 1.0f / 3.0f, 0};
    scene.meshes[0].uvs.clear();
    return scene;
}

TEST(SaveGlb, TrianglesComeBackBitForBit) {
    const Scene saved = fullScene();
    saveGlb(scratch("full.glb"), saved);
    const Scene loaded = loadGltf(scratch("full.glb"));
    ASSERT_EQ(loaded.meshes.size(), saved.meshes.size());
    for (std::size_t i = 0; i < saved.meshes.size(); ++i) {
        EXPECT_TRUE(sameBytes(loaded.meshes[i].positions, saved.meshes[i].positions));
        EXPECT_TRUE(sameBytes(loaded.meshes[i].normals, saved.meshes[i].normals));
        EXPECT_TRUE(sameBytes(loaded.meshes[i].uvs, saved.meshes[i].uvs));
        EXPECT_TRUE(sameBytes(loaded.meshes[i].triangles, saved.meshes[i].triangles));
        EXPECT_EQ(loaded.meshes[i].material, saved.meshes[i].material);
        EXPECT_EQ(loaded.meshes[i].name, saved.meshes[i].name);
    }
    EXPECT_EQ(loaded.name, "full");
}

TEST(SaveGlb, MaterialsAndTexturesComeBackEqual) {
    const Scene saved = fullScene();
    saveGlb(scratch("full.glb"), saved);
    const Scene loaded = loadGltf(scratch("full.glb"));
    ASSERT_EQ(loaded.materials.size(), saved.materials.size());
    for (std::size_t i = 0; i < saved.materials.size(); ++i) {
        EXPECT_EQ(loaded.materials[i].name, saved.materials[i].name);
        EXPECT_EQ(loaded.materials[i].baseColor, saved.materials[i].baseColor);
        EXPECT_EQ(loaded.materials[i].alphaCutoff, saved.materials[i].alphaCutoff);
        EXPECT_EQ(loaded.materials[i].emissive, saved.materials[i].emissive);
        EXPECT_EQ(loaded.materials[i].texture < 0, saved.materials[i].texture < 0);
        if (saved.materials[i].texture < 0) continue;
        const auto& a = loaded.textures.at(std::size_t(loaded.materials[i].texture));
        const auto& b = saved.textures.at(std::size_t(saved.materials[i].texture));
        EXPECT_EQ(a.width, b.width);
        EXPECT_EQ(a.height, b.height);
        EXPECT_EQ(a.rgba, b.rgba);
    }
}

TEST(SaveGlb, LightsComeBackBitForBit) {
    const Scene saved = fullScene();
    saveGlb(scratch("full.glb"), saved);
    const Scene loaded = loadGltf(scratch("full.glb"));
    EXPECT_EQ(loaded.lights, saved.lights);
}

TEST(SaveGlb, CameraKeepsEyeDirectionUpAndRange) {
    for (const std::string& name : builtInSceneNames()) {
        const Camera saved = loadScene(name).camera;
        saveGlb(scratch("camera.glb"), loadScene(name));
        const Camera loaded = loadGltf(scratch("camera.glb")).camera;
        EXPECT_EQ(loaded.eye, saved.eye);
        EXPECT_EQ(loaded.verticalFov, saved.verticalFov);
        EXPECT_EQ(loaded.nearPlane, saved.nearPlane);
        EXPECT_EQ(loaded.farPlane, saved.farPlane);
        const glm::mat4 a = saved.viewFromWorld(), b = loaded.viewFromWorld();
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                EXPECT_NEAR(a[column][row], b[column][row], 1e-6f) << name;
    }
}

TEST(SaveGlb, UnwritableFolderIsAnErrorAndLeavesNothing) {
    EXPECT_THROW(saveGlb(scratch("missing/x.glb"), loadScene("boxes")), Error);
    EXPECT_FALSE(std::filesystem::exists(scratch("missing")));
}

TEST(SensibleCamera, SeesTheWholeBox) {
    const Box box{{-1, 0, 2}, {5, 3, 4}};
    const Camera camera = sensibleCamera(box);
    const glm::mat4 clipFromWorld = camera.clipFromView(1.0f) * camera.viewFromWorld();
    for (int i = 0; i < 8; ++i) {
        const glm::vec4 clip =
            clipFromWorld * glm::vec4(i & 1 ? 5 : -1, i & 2 ? 3 : 0, i & 4 ? 4 : 2, 1);
        for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(clip[k]), clip.w);
    }
}

TEST(SensibleLight, FacesTheBoxFromAbove) {
    const Box box{{-1, 0, 2}, {5, 3, 4}};
    const Light light = sensibleLight(box);
    EXPECT_GT(light.center.y, box.upper.y);
    EXPECT_NEAR(glm::dot(light.forward(), glm::normalize(box.center() - light.center)), 1.0f,
                1e-5f);
    EXPECT_GT(light.width, 0.0f);
}

}  // namespace
}  // namespace penumbra
