#include "scene/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "scene/mesh_edges.h"

namespace penumbra {
namespace {

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool sameGeometry(const Scene& a, const Scene& b) {
    if (a.meshes.size() != b.meshes.size()) return false;
    for (std::size_t i = 0; i < a.meshes.size(); ++i)
        if (!sameBytes(a.meshes[i].positions, b.meshes[i].positions) ||
            !sameBytes(a.meshes[i].triangles, b.meshes[i].triangles))
            return false;
    return true;
}

void expectValid(const Scene& scene) {
    SCOPED_TRACE(scene.name);
    ASSERT_FALSE(scene.lights.empty());
    EXPECT_GT(triangleCount(scene), 0u);
    for (const Mesh& mesh : scene.meshes) {
        SCOPED_TRACE(mesh.name);
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        ASSERT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
        ASSERT_LT(std::size_t(mesh.material), scene.materials.size());
        for (const glm::vec3 p : mesh.positions) ASSERT_LT(glm::length(p), 100.0f);  // nor NaN
        for (const glm::vec3 n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
        for (const glm::uvec3 t : mesh.triangles)
            for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], mesh.positions.size());
    }
    for (const Light& light : scene.lights) {
        EXPECT_GT(light.width, 0.0f);
        EXPECT_NEAR(glm::length(light.right), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::length(light.up), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(light.right, light.up), 0.0f, 1e-5f);
    }
    EXPECT_GT(scene.camera.nearPlane, 0.0f);
    EXPECT_GT(scene.camera.farPlane, scene.camera.nearPlane);
}

std::string errorOf(const std::string& name) {
    try {
        loadScene(name);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST(Gallery, EverySceneIsValidForEverySeed) {
    for (const std::string& name : builtInSceneNames())
        for (const char* number : {"", "@0", "@1", "@2", "@7", "@42", "@80"})
            expectValid(loadScene(name + number));
    expectValid(loadScene("boxes@4294967295"));
    expectValid(loadScene("tilted@89.5"));
}

TEST(Gallery, SameSeedSameScene) {
    for (const std::string& name : builtInSceneNames()) {
        const Scene a = loadScene(name + "@7"), b = loadScene(name + "@7");
        EXPECT_TRUE(sameGeometry(a, b)) << name;
        EXPECT_EQ(a.camera.eye, b.camera.eye) << name;
        EXPECT_EQ(a.lights[0].center, b.lights[0].center) << name;
    }
}

TEST(Gallery, NoNumberMeansSeedOne) {
    for (const char* name : {"boxes", "fence", "foliage", "stairs", "halfplane", "polygon"})
        EXPECT_TRUE(sameGeometry(loadScene(name), loadScene(std::string(name) + "@1"))) << name;
}

TEST(Gallery, AnotherSeedMovesTheScene) {
    for (const char* name : {"boxes", "fence", "foliage", "stairs", "polygon"})
        EXPECT_FALSE(sameGeometry(loadScene(name), loadScene(std::string(name) + "@2"))) << name;
    EXPECT_NE(loadScene("halfplane").camera.eye, loadScene("halfplane@2").camera.eye);
}

TEST(Gallery, CameraSeesTheWholeDepthOfTheScene) {
    for (const std::string& name : builtInSceneNames()) {
        const Scene scene = loadScene(name);
        const glm::mat4 clipFromWorld =
            scene.camera.clipFromView(1.0f) * scene.camera.viewFromWorld();
        const glm::vec4 middle = clipFromWorld * glm::vec4(scene.camera.target, 1.0f);
        EXPECT_LT(std::abs(middle.z), middle.w) << name;
    }
}

TEST(Gallery, StandardLightsAreNineUnitsAwayAndTiltedBy25Degrees) {
    for (const char* name : {"boxes@3", "fence@3", "foliage@3", "stairs@3"}) {
        const Light light = loadScene(name).lights.at(0);
        EXPECT_EQ(light.width, 1.5f);
        EXPECT_NEAR(glm::length(light.center), 9.3f, 1e-4f);
        EXPECT_NEAR(light.center.y / 9.3f, std::cos(glm::radians(25.0f)), 1e-4f);
        EXPECT_NEAR(glm::dot(light.forward(), glm::normalize(-light.center)), 1.0f, 1e-5f);
    }
}

TEST(FenceScene, HasFortyEightPostsFromHalfToNearlyThreeHigh) {
    const Scene scene = loadScene("fence");
    EXPECT_EQ(scene.meshes.at(1).triangles.size(), 48u * 12u);
    EXPECT_NEAR(bounds(scene).upper.y, 2.8f, 1e-5f);
}

TEST(FoliageScene, HasTwoThousandLeaves) {
    EXPECT_EQ(loadScene("foliage").meshes.at(1).triangles.size(), 4000u);
}

TEST(HalfPlaneScene, BlockersEdgeIsExactlyAtZero) {
    const Scene scene = loadScene("halfplane");
    EXPECT_EQ(bounds(scene.meshes.at(1)).upper.x, 0.0f);
    EXPECT_EQ(bounds(scene.meshes.at(1)).lower.y, kHalfPlaneBlockerHeight);
    EXPECT_EQ(scene.lights.at(0).center, glm::vec3(0, kHalfPlaneLightHeight, 0));
    EXPECT_EQ(scene.lights.at(0).forward(), glm::vec3(0, -1, 0));
}

TEST(HalfPlaneScene, PenumbraFillsAGoodPartOfThePicture) {
    for (const char* name : {"halfplane", "halfplane@2", "halfplane@9"}) {
        const Camera camera = loadScene(name).camera;
        constexpr float kHalfWidth = 0.5f * kHalfPlaneLightWidth * kHalfPlaneBlockerHeight /
                                     (kHalfPlaneLightHeight - kHalfPlaneBlockerHeight);
        int inside = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const Ray ray = camera.pixelRay(x, y, {64, 64});
                ASSERT_LT(ray.direction.y, 0.0);
                const double hit = ray.origin.x - ray.origin.y * ray.direction.x / ray.direction.y;
                inside += std::abs(hit) < kHalfWidth;
            }
        EXPECT_GT(inside, 64 * 64 / 3) << name;
        EXPECT_LT(inside, 64 * 64 * 9 / 10) << name;
    }
}

TEST(PolygonScene, IsConvexPlanarAndBetweenGroundAndLight) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const auto v = polygonSceneVertices(seed);
        ASSERT_GE(v.size(), 5u);
        const glm::vec3 normal = glm::normalize(glm::cross(v[2] - v[0], v[1] - v[0]));
        for (std::size_t i = 0; i < v.size(); ++i) {
            const glm::vec3 a = v[i], b = v[(i + 1) % v.size()], c = v[(i + 2) % v.size()];
            EXPECT_LT(glm::cross(b - a, c - b).y, 0.0f) << seed;  // turns one way all around
            EXPECT_NEAR(glm::dot(a - v[0], normal), 0.0f, 1e-5f);
            EXPECT_GT(a.y, 0.5f);
            EXPECT_LT(a.y, kPolygonLightHeight);
        }
        EXPECT_EQ(loadScene("polygon@" + std::to_string(seed)).meshes.at(1).positions, v);
    }
}

TEST(TiltedScene, NumberIsTheAngleOfIncidence) {
    for (const double degrees : {0.0, 45.0, 80.0, 85.0, 89.5}) {
        const Light light = loadScene("tilted@" + std::to_string(degrees)).lights.at(0);
        const double cosine = glm::normalize(light.center).y;
        EXPECT_NEAR(glm::degrees(std::acos(double(cosine))), degrees, 0.03) << degrees;
        for (const float t : {-0.5f, 0.5f}) EXPECT_GT(light.point(0.5f, t).y, 0.0f) << degrees;
    }
}

std::vector<Mesh> casters(const Scene& scene, std::initializer_list<const char*> others) {
    std::vector<Mesh> found;
    for (const Mesh& mesh : scene.meshes)
        if (std::find(others.begin(), others.end(), mesh.name) == others.end())
            found.push_back(mesh);
    return found;
}

TEST(CourtyardScene, HasTenLightsThatEndAnd48ClosedCasters) {
    for (const char* name : {"courtyard", "courtyard@2", "courtyard@3"}) {
        const Scene scene = loadScene(name);
        const auto found = casters(scene, {"paving", "wall", "bulb", "hat"});
        EXPECT_EQ(found.size(), std::size_t(kCourtyardCasters));
        for (const Mesh& mesh : found) EXPECT_TRUE(closed(meshEdges(mesh))) << mesh.name;
        ASSERT_EQ(scene.lights.size(), std::size_t(kCourtyardLights));
        for (const Light& light : scene.lights) EXPECT_LT(light.range, 10.0f);
        EXPECT_LT(triangleCount(scene), 20000u);
    }
}

TEST(CourtyardScene, LanternsStandAboveTheirLightsPlanes) {
    const Scene scene = loadScene("courtyard");
    std::size_t light = 0;
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.name != "bulb") continue;
        const Light& own = scene.lights.at(light++);
        EXPECT_GT(bounds(mesh).lower.y, own.center.y);
        EXPECT_LT(glm::distance(bounds(mesh).center(), own.center), 0.2f);
        EXPECT_EQ(own.forward(), glm::vec3(0, -1, 0));
        EXPECT_GT(scene.materials.at(std::size_t(mesh.material)).emissive.x, 0.0f);
    }
    EXPECT_EQ(light, scene.lights.size());
}

TEST(NestedScene, NumberIsTheCountOfSheets) {
    EXPECT_EQ(loadScene("nested").meshes.at(1).triangles.size(), 256u * 12u);
    EXPECT_EQ(loadScene("nested@1000").meshes.at(1).triangles.size(), 1000u * 12u);
    EXPECT_TRUE(closed(meshEdges(loadScene("nested@300").meshes.at(1))));
    EXPECT_EQ(loadScene("nested@0").meshes.size(), 1u);
}

TEST(SunScene, IsLitFromAfar) { EXPECT_EQ(loadScene("sun").lights.at(0).position().w, 0.0f); }

TEST(LampScenes, HoldTheLightInTheHollowOrInTheSolid) {
    for (const char* seed : {"@1", "@2", "@9"}) {
        const Scene lamp = loadScene(std::string("lamp") + seed);
        const Mesh& cage = lamp.meshes.at(1);
        EXPECT_TRUE(facingTrianglesSuffice(cage, meshEdges(cage), lamp.lights[0].position()));
        const Scene shut = loadScene(std::string("shut_lamp") + seed);
        const Mesh& globe = shut.meshes.at(1);
        EXPECT_TRUE(closed(meshEdges(globe)));
        EXPECT_EQ(windingNumber(globe, shut.lights[0].center), 1);
    }
}

TEST(OpenMeshScene, HasNoClosedMesh) {
    const Scene scene = loadScene("open_mesh");
    for (const Mesh& mesh : scene.meshes) EXPECT_FALSE(closed(meshEdges(mesh))) << mesh.name;
    EXPECT_EQ(meshReport(meshEdges(scene.meshes.at(2))).oddEdges, 1u) << "three faces";
    for (const glm::vec3 p : scene.meshes.at(5).positions)
        EXPECT_EQ(p.x, scene.lights[0].center.x) << "light in its plane";
    EXPECT_EQ(meshReport(meshEdges(scene.meshes.at(6))).degenerateTriangles, 3u);
}

TEST(PlanarScenes, HaveOneOpenReceiverFirstAndClosedCasters) {
    for (const char* name : {"board", "board@0", "board@60", "hollow", "hollow@4", "mast"}) {
        const Scene scene = loadScene(name);
        EXPECT_FALSE(closed(meshEdges(scene.meshes.at(0)))) << name;
        for (std::size_t i = 1; i < scene.meshes.size(); ++i)
            EXPECT_TRUE(closed(meshEdges(scene.meshes[i]))) << name;
    }
}

TEST(BoardScene, NumberIsTheTilt) {
    for (const float degrees : {0.0f, 30.0f, 75.0f}) {
        const Scene scene = loadScene("board@" + std::to_string(degrees));
        const glm::vec3 normal = scene.meshes.at(0).normals.at(0);
        EXPECT_NEAR(glm::degrees(std::acos(normal.y)), degrees, 0.05f);
        EXPECT_GT(glm::dot(normal, scene.lights.at(0).center), 0.0f);
    }
}

TEST(MastScene, ReachesAboveTheLightAndBelowTheGround) {
    for (const char* name : {"mast", "mast@2", "mast@5"}) {
        const Scene scene = loadScene(name);
        const float light = scene.lights.at(0).center.y;
        const auto box = [&](std::size_t i) { return bounds(scene.meshes.at(i)); };
        EXPECT_LT(box(1).lower.y, light);
        EXPECT_GT(box(1).upper.y, light) << "mast";
        EXPECT_GT(box(2).lower.y, light) << "yard";
        EXPECT_LT(box(3).lower.y, 0.0f);
        EXPECT_GT(box(3).upper.y, 0.0f) << "buoy";
        EXPECT_LT(box(5).upper.y, 0.0f) << "block below";
    }
}

TEST(SceneName, UnknownNameListsTheKnownOnes) {
    const std::string error = errorOf("fense");
    EXPECT_NE(error.find("unknown scene: fense"), std::string::npos) << error;
    EXPECT_NE(error.find("boxes fence foliage stairs halfplane polygon tilted"), std::string::npos);
    EXPECT_EQ(error.find('\n'), std::string::npos);
    EXPECT_NE(errorOf("").find("unknown scene"), std::string::npos);
    EXPECT_NE(errorOf("..").find("unknown scene"), std::string::npos);
}

TEST(SceneName, BadNumbersAreRefused) {
    for (const char* name : {"fence@", "fence@x", "fence@-1", "fence@1.5", "fence@1x", "fence@1e99",
                             "fence@nan", "fence@1@2", "tilted@90", "tilted@-1", "tilted@inf",
                             "nested@1.5", "nested@1001", "board@81"})
        EXPECT_NE(errorOf(name).find("bad number in scene name"), std::string::npos) << name;
}

TEST(SceneName, SlashOrEndingMeansAPath) {
    EXPECT_NE(errorOf("no/such").find("no such file: no/such"), std::string::npos);
    EXPECT_NE(errorOf("fence.glb").find("no such file: fence.glb"), std::string::npos);
    EXPECT_NE(errorOf("/").find("not a file"), std::string::npos);
}

}  // namespace
}  // namespace penumbra
