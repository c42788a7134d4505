#include "truth/ray_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <random>

#include "truth/closed_form.h"
#include "truth/test_scene.h"

namespace penumbra {

using namespace testing;

namespace {

float random01(std::mt19937& engine) { return float(engine() >> 8) / 16777216.0f; }
glm::vec3 randomPoint(std::mt19937& engine) {  // in [-1,1]³, in a fixed order
    const float x = random01(engine), y = random01(engine), z = random01(engine);
    return 2.0f * glm::vec3(x, y, z) - 1.0f;
}

Scene triangleSoup(int count, std::mt19937& engine) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = randomPoint(engine);
        for (int k = 0; k < 3; ++k) mesh.positions.push_back(center + 0.3f * randomPoint(engine));
        const unsigned first = 3u * unsigned(i);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return sceneOf({mesh});
}

std::vector<glm::dvec3> corners(const Scene& scene) {
    std::vector<glm::dvec3> result;
    for (const Mesh& mesh : scene.meshes)
        for (const glm::uvec3 t : mesh.triangles)
            for (int k = 0; k < 3; ++k) result.push_back(mesh.positions[t[k]]);
    return result;
}

// A roof whose alpha runs from 0 at u = 1/4 to 1 at u = 3/4 and back across the repeat.
Scene maskedRoof() {
    Mesh roof = rectangle({-1, 2, 1}, {2, 0, 0}, {0, 0, -2});
    roof.material = 1;
    Scene scene = sceneOf({floorSquare(10), roof});
    scene.materials.push_back({.name = "leaf", .texture = 0, .alphaCutoff = 0.5f});
    scene.textures.push_back({2, 1, {0, 0, 0, 0, 0, 0, 0, 255}});
    return scene;
}

bool isBlocked(const RayTracer& tracer, glm::vec3 from, glm::vec3 to) {
    const glm::vec3 up(0, 1, 0);
    std::uint8_t blocked = 9;
    tracer.occluded({&from, 1}, {&up, 1}, {&to, 1}, {&blocked, 1});
    return blocked == 1;
}

}  // namespace

TEST(RayTracer, AgreesWithTheFloat64PredicateOnATriangleSoup) {
    std::mt19937 engine(7);
    const Scene scene = triangleSoup(200, engine);
    const RayTracer tracer(scene);
    const auto triangles = corners(scene);
    constexpr std::size_t kSegments = 20000;
    std::vector<glm::vec3> from, to, normals;
    for (std::size_t i = 0; i < kSegments; ++i) {
        from.push_back(1.5f * randomPoint(engine));
        to.push_back(1.5f * randomPoint(engine));
        normals.push_back(glm::normalize(to.back() - from.back()));
    }
    std::vector<std::uint8_t> blocked(kSegments);
    tracer.occluded(from, normals, to, blocked);
    int free = 0;
    for (std::size_t i = 0; i < kSegments; ++i) {
        double margin = 0.0;
        const bool isFree = segmentIsFree(from[i], {glm::dvec3(to[i]), 1}, triangles, &margin);
        free += isFree;
        // Start and end are held back by the start offset, some 2e-6 of the scene's size of 5.
        if (isFree != (blocked[i] == 0)) {
            EXPECT_LT(margin, 2e-5) << "segment " << i;
        }
    }
    EXPECT_GT(free, int(kSegments) / 10);
    EXPECT_LT(free, int(kSegments) * 9 / 10);
}

TEST(RayTracer, AFacetNeverBlocksItself) {
    std::mt19937 engine(3);
    for (int round = 0; round < 200; ++round) {
        const glm::vec3 u = glm::normalize(randomPoint(engine));
        const glm::vec3 v = glm::normalize(glm::cross(u, randomPoint(engine)));
        const float size = std::exp2(10.0f * randomPoint(engine).x);
        const glm::vec3 corner = 3.0f * size * randomPoint(engine);
        const RayTracer tracer(sceneOf({rectangle(corner, size * u, 2.0f * size * v)}));
        const glm::vec3 normal = glm::normalize(glm::cross(u, v));
        std::vector<glm::vec3> from, to;
        for (int i = 0; i < 200; ++i) {
            const float s = random01(engine), t = random01(engine);
            from.push_back(corner + s * size * u + 2 * t * size * v);
            // Down to a hair above the horizon.
            const float height = std::exp2(-20.0f * random01(engine));
            const float along = randomPoint(engine).x, across = randomPoint(engine).y;
            to.push_back(from.back() +
                         size * (5.0f * along * u + 5.0f * across * v + height * normal));
        }
        std::vector<std::uint8_t> blocked(from.size());
        tracer.occluded(from, std::vector<glm::vec3>(from.size(), normal), to, blocked);
        for (std::size_t i = 0; i < from.size(); ++i) EXPECT_EQ(blocked[i], 0) << round << " " << i;
    }
}

TEST(RayTracer, ReceiversLieOnTheSurfaceUnderThePixelCentre) {
    Scene scene = sceneOf({floorSquare(20)});
    const RayTracer tracer(scene);
    const glm::ivec2 size(64, 32);
    const Receivers receivers = tracer.receivers(scene.camera, size);
    int hits = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::size_t i = std::size_t(y * size.x + x);
            const Ray ray = scene.camera.pixelRay(x, y, size);
            const glm::dvec3 expected = ray.origin - ray.origin.y / ray.direction.y * ray.direction;
            const bool onFloor =
                ray.direction.y < 0 && std::abs(expected.x) < 10 && std::abs(expected.z) < 10;
            ASSERT_EQ(receivers.hit[i] != 0, onFloor);
            if (!onFloor) continue;
            ++hits;
            // Positions are float64 intersections rounded to float once: half an ulp of 16.
            EXPECT_LT(glm::distance(glm::dvec3(receivers.positions[i]), expected), 1e-6);
            EXPECT_EQ(receivers.facetNormals[i], glm::vec3(0, 1, 0));
        }
    EXPECT_GT(hits, 1000);
    EXPECT_LT(hits, 64 * 32);
}

TEST(RayTracer, FacetNormalsFaceTheEyeFromBothSides) {
    Scene scene = sceneOf({floorSquare(20)});
    scene.camera.eye.y = -4;
    const Receivers receivers = RayTracer(scene).receivers(scene.camera, {8, 8});
    ASSERT_TRUE(receivers.hit[36]);
    EXPECT_EQ(receivers.facetNormals[36], glm::vec3(0, -1, 0));
}

TEST(RayTracer, SeesNothingBeyondTheCamerasPlanes) {
    Scene scene = sceneOf({floorSquare(20)});
    scene.camera.farPlane = 8.0f;  // the target lies at distance 8.94
    EXPECT_FALSE(RayTracer(scene).receivers(scene.camera, {9, 9}).hit[40]);
    scene.camera.farPlane = 9.0f;
    EXPECT_TRUE(RayTracer(scene).receivers(scene.camera, {9, 9}).hit[40]);
    scene.camera.nearPlane = 8.95f;
    EXPECT_FALSE(RayTracer(scene).receivers(scene.camera, {9, 9}).hit[40]);
}

TEST(RayTracer, HolesOfAMaskLetLightAndSightThrough) {
    const RayTracer tracer(maskedRoof());
    // u = (x + 1) / 2; alpha is 0 at u = 1/4, 1 at u = 3/4, 1/2 at u = 1/2.
    EXPECT_FALSE(isBlocked(tracer, {-0.5f, 0, 0}, {-0.5f, 5, 0}));
    EXPECT_FALSE(isBlocked(tracer, {-0.01f, 0, 0}, {-0.01f, 5, 0}));
    EXPECT_TRUE(isBlocked(tracer, {0.01f, 0, 0}, {0.01f, 5, 0}));
    EXPECT_TRUE(isBlocked(tracer, {0.5f, 0, 0}, {0.5f, 5, 0}));
    // The repeat joins both ends: alpha passes 1/2 downwards at u = 0 = 1.
    EXPECT_FALSE(isBlocked(tracer, {-0.99f, 0, 0}, {-0.99f, 5, 0}));
    EXPECT_TRUE(isBlocked(tracer, {0.99f, 0, 0}, {0.99f, 5, 0}));
    const Camera fromAbove{
        .eye = {0, 6, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .verticalFov = 0.4f};
    const Receivers seen = tracer.receivers(fromAbove, {64, 64});
    EXPECT_NEAR(seen.positions[32 * 64 + 20].y, 0.0f, 1e-6f);
    EXPECT_NEAR(seen.positions[32 * 64 + 44].y, 2.0f, 1e-6f);
}

TEST(RayTracer, DepthOfATiltedPlaneIsTheProjectedDepth) {
    // y = x / 2 under an oblique perspective view: depth by intersecting in float64.
    const RayTracer tracer(sceneOf({rectangle({-32, -16, 32}, {64, 32, 0}, {0, 0, -64})}));
    const glm::mat4 clipFromWorld =
        glm::perspective(0.9f, 1.0f, 2.0f, 30.0f) *
        glm::lookAt(glm::vec3(3, 9, 2), glm::vec3(0), glm::vec3(0, 0, 1));
    const glm::ivec2 size(40, 30);
    const Image depth = tracer.depth(clipFromWorld, size);
    const glm::dmat4 clip(clipFromWorld);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            // Plane coefficients in clip space are those of the world times the inverse matrix.
            const glm::dvec4 plane = glm::dvec4(0.5, -1, 0, 0) * glm::inverse(clip);
            const double u = 2 * (x + 0.5) / size.x - 1, v = 1 - 2 * (y + 0.5) / size.y;
            const double z = -(plane.x * u + plane.y * v + plane.w) / plane.z;
            // Half an ulp of depth in [1/2, 1], and as much for float64's own steps.
            EXPECT_NEAR(depth.at(x, y), 0.5 * z + 0.5, 1.2e-7);
        }
}

TEST(RayTracer, DepthIsOneWhereNothingIsAndReadsInfiniteProjections) {
    const RayTracer tracer(sceneOf({floorSquare(2)}));
    const glm::mat4 view = glm::lookAt(glm::vec3(0, 5, 0), glm::vec3(0), glm::vec3(0, 0, -1));
    const Image finite = tracer.depth(glm::ortho(-2.f, 2.f, -2.f, 2.f, 1.f, 9.f) * view, {4, 4});
    EXPECT_EQ(finite.at(0, 0), 1.0f);
    EXPECT_NEAR(finite.at(1, 1), 0.5f, 1e-7f);
    const Image infinite = tracer.depth(glm::infinitePerspective(0.5f, 1.0f, 1.0f) * view, {3, 3});
    EXPECT_NEAR(infinite.at(1, 1), 1.0f - 1.0f / 5.0f,
                1e-6f);  // window depth 1 - n / z, float matrix
}

TEST(RayTracer, ScalesByPowersOfTwoBitForBit) {
    std::mt19937 engine(5);
    const Scene scene = triangleSoup(300, engine);
    const Receivers reference = RayTracer(scene).receivers(scene.camera, {48, 48});
    for (const int k : {-10, -3, 4, 10}) {
        const float factor = std::ldexp(1.0f, k);
        const Scene other = scaled(scene, factor);
        const Receivers receivers = RayTracer(other).receivers(other.camera, {48, 48});
        EXPECT_EQ(receivers.hit, reference.hit) << k;
        EXPECT_EQ(receivers.facetNormals, reference.facetNormals) << k;
        for (std::size_t i = 0; i < reference.positions.size(); ++i)
            EXPECT_EQ(receivers.positions[i], factor * reference.positions[i]) << k;
    }
}

TEST(RayTracer, AnEmptySceneIsAllBackground) {
    Scene scene;
    const RayTracer tracer(scene);
    const Receivers receivers = tracer.receivers(scene.camera, {3, 2});
    EXPECT_EQ(receivers.hit, std::vector<std::uint8_t>(6, 0));
    EXPECT_FALSE(isBlocked(tracer, {0, 0, 0}, {0, 1, 0}));
}

}  // namespace penumbra
