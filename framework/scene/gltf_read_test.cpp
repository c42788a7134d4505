// What is read from good files of every kind.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "core/error.h"
#include "scene/gltf.h"
#include "scene/gltf_test_model.h"
#include "scene/scratch_folder.h"

namespace penumbra {
namespace {

const ScratchFolder& scratch() {
    static const ScratchFolder folder;
    return folder;
}

Scene loaded(const TestModel& model) {
    writeBytes(scratch() / "model.glb", model.glb());
    return loadGltf(scratch() / "model.glb");
}

glm::vec3 facetNormal(const Mesh& mesh, std::size_t i) {
    const glm::uvec3 t = mesh.triangles[i];
    const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    return glm::normalize(glm::cross(b - a, c - a));
}

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5f) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

TEST(Gltf, ReadsMeshMaterialTextureCameraAndLight) {
    const Scene scene = loaded({});
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_EQ(scene.meshes[0].uvs[2], glm::vec2(1, 1));
    EXPECT_EQ(scene.materials.at(0).baseColor, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(scene.materials.at(0).alphaCutoff, 0.25f);
    EXPECT_EQ(scene.textures.at(0).rgba[7], 128);
    EXPECT_EQ(scene.camera.eye, glm::vec3(0, 0, 5));
    EXPECT_EQ(scene.camera.verticalFov, 0.5f);
    EXPECT_EQ(scene.lights.at(0).width, 0.75f);
    expectNear(scene.lights.at(0).forward(), {0, 0, -1});
}

TEST(Gltf, JsonWithFilesBesideItReadsLikeGlb) {
    TestModel model;
    std::filesystem::create_directories(scratch() / "parts");
    writeBytes(scratch() / "parts/data 1.bin", model.binary);
    model.root["buffers"][0]["uri"] = "parts/data%201.bin";
    writeBytes(scratch() / "model.gltf", model.root.dump());
    EXPECT_EQ(loadGltf(scratch() / "model.gltf").meshes.at(0).positions,
              loaded({}).meshes.at(0).positions);
}

TEST(Gltf, DataUriReads) {
    TestModel model;
    // positions (0 0 0) (1 0 0) (0 1 0)
    model.root["buffers"].push_back(
        {{"byteLength", 36},
         {"uri",
          "data:application/"
          "octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}});
    model.root["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 36}});
    model.root["accessors"].push_back(
        {{"bufferView", 5}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
    model.root["meshes"][0]["primitives"] = {{{"attributes", {{"POSITION", 4}}}}};
    const Mesh mesh = loaded(model).meshes.at(0);
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(Gltf, NodesMultiplyFromTheRootDown) {
    TestModel model;
    model.root["scenes"][0]["nodes"] = {3};
    const double h = std::sqrt(0.5);
    model.root["nodes"].push_back({{"children", {0}},
                                   {"translation", {10, 0, 0}},
                                   {"rotation", {0, 0, h, h}},
                                   {"scale", {2, 2, 2}}});
    model.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1};
    const Mesh mesh = loaded(model).meshes.at(0);
    expectNear(mesh.positions[0], {4, 0, 0});  // (0,3,0) doubled, turned by 90 degrees, moved
    expectNear(mesh.positions[1], {4, 2, 0});
    expectNear(mesh.normals[0], {0, 0, 1});
}

TEST(Gltf, MirroredMeshKeepsItsNormalsOnTheFrontSide) {
    TestModel model;
    model.root["nodes"][0]["scale"] = {-1, 2, 0.5};
    const Mesh mesh = loaded(model).meshes.at(0);
    expectNear(mesh.normals[0], {0, 0, 1});
    expectNear(facetNormal(mesh, 0), {0, 0, 1});
    model.primitive()["attributes"].erase("NORMAL");
    expectNear(loaded(model).meshes.at(0).normals[0], {0, 0, 1});
}

TEST(Gltf, NormalsStayPerpendicularUnderUnevenScale) {
    TestModel model;
    const float h = std::sqrt(0.5f);
    std::vector<float> slope = {0, 0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0};  // z = x
    std::vector<float> normals;
    for (int i = 0; i < 4; ++i) normals.insert(normals.end(), {-h, 0.0f, h});
    model.primitive()["attributes"]["POSITION"] = model.addAccessor(slope, 5126, "VEC3", 4);
    model.primitive()["attributes"]["NORMAL"] = model.addAccessor(normals, 5126, "VEC3", 4);
    model.root["nodes"][0]["scale"] = {3, 1, 1};
    const Mesh mesh = loaded(model).meshes.at(0);
    expectNear(mesh.normals[0], facetNormal(mesh, 0));
}

TEST(Gltf, FlattenedMeshStaysFinite) {
    TestModel model;
    model.root["nodes"][0]["scale"] = {1, 1, 0};
    const Scene flat = loaded(model);
    for (const glm::vec3 n : flat.meshes.at(0).normals) expectNear(n, {0, 0, 1});
    model.root["nodes"][0]["scale"] = {0, 0, 0};
    const Scene point = loaded(model);
    for (const glm::vec3 n : point.meshes.at(0).normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
}

TEST(Gltf, MissingNormalsAreWeightedByArea) {
    TestModel model;
    // Two facets share vertices 0 and 1: area 1/2 facing +z, area 3/2 facing +y.
    const std::vector<float> p = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, -3};
    model.primitive()["attributes"] = {{"POSITION", model.addAccessor(p, 5126, "VEC3", 4)}};
    model.primitive()["indices"] =
        model.addAccessor<std::uint8_t>({0, 1, 2, 0, 1, 3}, 5121, "SCALAR", 6);
    const Mesh mesh = loaded(model).meshes.at(0);
    expectNear(mesh.normals[0], glm::normalize(glm::vec3(0, 3, 1)));
    expectNear(mesh.normals[2], {0, 0, 1});
}

TEST(Gltf, StripsAndFansTurnAllTrianglesTheSameWay) {
    const std::vector<float> zigzag = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
    TestModel strip;
    strip.primitive() = {
        {"mode", 5}, {"attributes", {{"POSITION", strip.addAccessor(zigzag, 5126, "VEC3", 5)}}}};
    const Mesh mesh = loaded(strip).meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) expectNear(facetNormal(mesh, i), {0, 0, 1});

    TestModel fan;
    fan.primitive()["mode"] = 6;
    fan.primitive().erase("indices");
    const Mesh fanned = loaded(fan).meshes.at(0);
    ASSERT_EQ(fanned.triangles.size(), 2u);
    EXPECT_EQ(fanned.triangles[1], glm::uvec3(0, 2, 3));
}

TEST(Gltf, SeamsOfStripsVanish) {
    TestModel model;
    model.primitive()["mode"] = 5;
    model.primitive()["indices"] =
        model.addAccessor<std::uint32_t>({0, 1, 2, 2, 0, 0, 2, 3}, 5125, "SCALAR", 8);
    EXPECT_EQ(loaded(model).meshes.at(0).triangles.size(), 2u);
}

TEST(Gltf, InterleavedVerticesRead) {
    TestModel model;
    const std::vector<float> vertices = {0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0, 9, 9};
    const std::size_t position = model.addAccessor(vertices, 5126, "VEC3", 3);
    model.root["bufferViews"][5]["byteStride"] = 20;
    model.primitive() = {{"attributes", {{"POSITION", position}}}};
    EXPECT_EQ(loaded(model).meshes.at(0).positions[2], glm::vec3(0, 1, 0));
}

TEST(Gltf, SparseAndNormalizedAccessorsRead) {
    TestModel model;
    const std::size_t at = model.addAccessor<std::uint8_t>({1}, 5121, "SCALAR", 1);
    const std::size_t to = model.addAccessor<float>({5, 6, 7}, 5126, "VEC3", 1);
    model.root["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", model.root["accessors"][at]["bufferView"]}, {"componentType", 5121}}},
        {"values", {{"bufferView", model.root["accessors"][to]["bufferView"]}}}};
    std::size_t uv = model.addAccessor<std::uint8_t>({0, 255, 51, 0, 0, 0, 0, 0}, 5121, "VEC2", 4);
    model.root["accessors"][uv]["normalized"] = true;
    model.primitive()["attributes"]["TEXCOORD_0"] = uv;
    const Mesh mesh = loaded(model).meshes.at(0);
    EXPECT_EQ(mesh.positions[1], glm::vec3(5, 6, 7));
    EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 0));
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(mesh.uvs[1].x, 0.2f);
}

TEST(Gltf, TextureChoosesItsCoordinates) {
    TestModel model;
    model.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    model.primitive()["attributes"]["TEXCOORD_1"] =
        model.addAccessor<float>({7, 8, 0, 0, 0, 0, 0, 0}, 5126, "VEC2", 4);
    EXPECT_EQ(loaded(model).meshes.at(0).uvs[0], glm::vec2(7, 8));
}

TEST(Gltf, PrimitivesWithoutMaterialGetTheWhiteDefault) {
    TestModel model;
    auto second = model.primitive();
    second.erase("material");
    model.root["meshes"][0]["primitives"].push_back(second);
    const Scene scene = loaded(model);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].material, 0);
    EXPECT_EQ(scene.materials.at(std::size_t(scene.meshes[1].material)).baseColor, glm::vec3(1.0f));
}

TEST(Gltf, BlendedSurfacesAreCutAtOneHalf) {
    TestModel model;
    model.root["materials"][0]["alphaMode"] = "BLEND";
    EXPECT_EQ(loaded(model).materials.at(0).alphaCutoff, 0.5f);
    model.root["materials"][0].erase("alphaMode");
    EXPECT_EQ(loaded(model).materials.at(0).alphaCutoff, 0.0f);
}

TEST(Gltf, AlphaFactorMovesTheCutoffOfTheTexture) {
    TestModel model;
    auto& material = model.root["materials"][0];
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.5};
    EXPECT_EQ(loaded(model).materials.at(0).alphaCutoff, 0.5f);  // 0.5 a < 0.25 is a < 0.5
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.125};  // nothing is left
    EXPECT_THROW(loaded(model), Error);
}

TEST(Gltf, DirectionalLightShinesFromBeyondTheScene) {
    TestModel model;
    auto& light = model.root["extensions"]["KHR_lights_punctual"]["lights"][0];
    light = {{"type", "directional"}, {"intensity", 5000}, {"color", {1, 0.5, 0}}};
    const Scene scene = loaded(model);
    EXPECT_GT(scene.lights.at(0).center.z, 1.0f);
    expectNear(scene.lights.at(0).forward(), {0, 0, -1});
    EXPECT_GT(scene.lights.at(0).width, 0.01f);
    EXPECT_EQ(scene.lights.at(0).color, glm::vec3(1, 0.5f, 0));
    EXPECT_TRUE(scene.lights.at(0).directional);
}

TEST(Gltf, ADirectionalLightInTheSceneIsPutBeyondIt) {
    TestModel model;
    auto& light = model.root["extensions"]["KHR_lights_punctual"]["lights"][0];
    light = {{"type", "directional"}, {"extras", {{"width", 0.5}}}};
    EXPECT_EQ(loaded(model).lights.at(0).center, glm::vec3(0, 0, 3));  // faces all of the scene
    model.root["nodes"][2]["translation"] = {0, 0, -1};
    EXPECT_GT(loaded(model).lights.at(0).center.z, 1.0f);
}

TEST(Gltf, ReadsALightsRange) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    TestModel model;
    auto& light = model.root["extensions"]["KHR_lights_punctual"]["lights"][0];
    EXPECT_EQ(loaded(model).lights.at(0).range, kInfinity);
    for (const char* type : {"point", "spot"}) {
        light = {{"type", type}, {"range", 12.5}};
        EXPECT_EQ(loaded(model).lights.at(0).range, 12.5f) << type;
    }
    light = {{"type", "directional"}, {"range", 12.5}};  // glTF: for point and spot alone
    EXPECT_EQ(loaded(model).lights.at(0).range, kInfinity);
}

TEST(Gltf, ReadsEmissiveFactorTimesStrength) {
    TestModel model;
    auto& material = model.root["materials"][0];
    EXPECT_EQ(loaded(model).materials.at(0).emissive, glm::vec3(0.0f));
    material["emissiveFactor"] = {1, 0.5, 0};
    EXPECT_EQ(loaded(model).materials.at(0).emissive, glm::vec3(1, 0.5f, 0));
    material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 4;
    EXPECT_EQ(loaded(model).materials.at(0).emissive, glm::vec3(4, 2, 0));
    material["emissiveTexture"] = {{"index", 0}};  // its picture alone says where it shines
    EXPECT_EQ(loaded(model).materials.at(0).emissive, glm::vec3(0.0f));
}

TEST(Gltf, PointLightWithoutWidthFacesTheScene) {
    TestModel model;
    auto& light = model.root["extensions"]["KHR_lights_punctual"]["lights"][0];
    light = {{"type", "point"}};
    model.root["nodes"][2]["translation"] = {5.5, 0.5, 0};
    expectNear(loaded(model).lights.at(0).forward(), {-1, 0, 0});
}

TEST(Gltf, MirroredLightStillFacesAlongItsNodesMinusZ) {
    TestModel model;
    model.root["nodes"][2]["scale"] = {-3, 1, 2};
    const Light light = loaded(model).lights.at(0);
    expectNear(light.forward(), {0, 0, -1});
    EXPECT_EQ(light.width, 0.75f);
}

TEST(Gltf, OrthographicCameraBecomesANarrowPinholeOfTheSameExtent) {
    TestModel model;
    model.root["cameras"][0] = {
        {"type", "orthographic"},
        {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 10}}}};
    const Camera camera = loaded(model).camera;
    EXPECT_NEAR(camera.eye.z * std::tan(0.5f * camera.verticalFov), 2.0f, 1e-3f);
    expectNear(glm::normalize(camera.target - camera.eye), {0, 0, -1});
    EXPECT_LT(camera.nearPlane, camera.eye.z);
    EXPECT_GT(camera.farPlane, camera.eye.z);
}

TEST(Gltf, InfiniteFarPlaneBecomesOneBeyondTheScene) {
    TestModel model;
    model.root["cameras"][0]["perspective"].erase("zfar");
    const Camera camera = loaded(model).camera;
    EXPECT_GT(camera.farPlane, 5.0f);
    EXPECT_LT(camera.farPlane, 100.0f);
}

TEST(Gltf, WithoutCameraAndLightSensibleOnesArePlaced) {
    TestModel model;
    model.root["scenes"][0]["nodes"] = {0};
    const Scene scene = loaded(model);
    const glm::mat4 clipFromWorld = scene.camera.clipFromView(1.0f) * scene.camera.viewFromWorld();
    for (const glm::vec3 p : scene.meshes.at(0).positions) {
        const glm::vec4 clip = clipFromWorld * glm::vec4(p, 1.0f);
        for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(clip[k]), clip.w);
    }
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_GT(scene.lights[0].center.y, 1.0f);
}

}  // namespace
}  // namespace penumbra
