#include "scene/shapes.h"

#include <gtest/gtest.h>

#include "scene/mesh_edges.h"

namespace penumbra {
namespace {

// Twice the facet's area times its unit normal.
glm::vec3 facetNormal(const Mesh& mesh, glm::uvec3 t) {
    return glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                      mesh.positions[t.z] - mesh.positions[t.x]);
}

// Signed volume of a closed mesh: positive if facets turn counter-clockwise seen from outside.
double volume(const Mesh& mesh) {
    double six = 0.0;
    for (const glm::uvec3 t : mesh.triangles)
        six += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
    return six / 6.0;
}

void expectNormalsAlongFacets(const Mesh& mesh) {
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::vec3 facet = facetNormal(mesh, t);
        EXPECT_GT(glm::length(facet), 0.0f);
        for (int k = 0; k < 3; ++k) EXPECT_GT(glm::dot(facet, mesh.normals[t[k]]), 0.0f);
    }
}

TEST(Box, IsClosedAndFacesOutwards) {
    const Mesh mesh = box({-1, 0, 2}, {1, 3, 6}, 4);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(mesh.material, 4);
    EXPECT_NEAR(volume(mesh), 2 * 3 * 4, 1e-4);
    expectNormalsAlongFacets(mesh);
    EXPECT_EQ(bounds(mesh).lower, glm::vec3(-1, 0, 2));
    EXPECT_EQ(bounds(mesh).upper, glm::vec3(1, 3, 6));
}

TEST(Quad, NormalFollowsTheRightHand) {
    const Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, 0);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    expectNormalsAlongFacets(mesh);
}

TEST(Sphere, VolumeApproachesTheBallsFromBelow) {
    const Mesh mesh = sphere({1, 2, 3}, 2.0f, 32, 0);
    const double ball = 4.0 / 3.0 * 3.14159265 * 8.0;
    EXPECT_LT(volume(mesh), ball);
    EXPECT_GT(volume(mesh), 0.99 * ball);
    for (const glm::vec3 p : mesh.positions) EXPECT_NEAR(glm::distance(p, {1, 2, 3}), 2.0f, 1e-5f);
    expectNormalsAlongFacets(mesh);
}

TEST(Sphere, SeamVerticesCoincide) {
    const Mesh mesh = sphere({0, 0, 0}, 1.0f, 4, 0);
    for (std::size_t ring = 0; ring <= 4; ++ring)
        EXPECT_EQ(mesh.positions[ring * 9], mesh.positions[ring * 9 + 8]);
}

TEST(Ground, FacesUpAndHasItsSize) {
    const Mesh mesh = ground(12.0f, 3, 0);
    EXPECT_EQ(mesh.triangles.size(), 18u);
    EXPECT_EQ(bounds(mesh).lower, glm::vec3(-6, 0, -6));
    EXPECT_EQ(bounds(mesh).upper, glm::vec3(6, 0, 6));
    float doubleArea = 0.0f;
    for (const glm::uvec3 t : mesh.triangles) doubleArea += facetNormal(mesh, t).y;
    EXPECT_NEAR(doubleArea, 2 * 144.0f, 1e-3f);
}

constexpr double kPi = 3.14159265358979;

TEST(Lathe, TurnsAnOutlineIntoAClosedSolid) {
    // A cone on a cylinder, with a dent in its base.
    const Mesh mesh = lathe({3, 1, -2}, {{0, 0.5f}, {1, 0}, {2, 0}, {2, 1}, {0, 4}}, 96, 1);
    expectNormalsAlongFacets(mesh);
    EXPECT_TRUE(closed(meshEdges(mesh))) << meshReport(meshEdges(mesh)).text();
    const double exact = kPi * (4.0 * 1.0 + 4.0 * 3.0 / 3.0 - 0.5 / 3.0);
    EXPECT_NEAR(signedVolume(mesh), exact, 2e-3 * exact);  // 96-gon: 1 - sin(2π/96) / (2π/96)
    EXPECT_EQ(bounds(mesh).upper.y, 5.0f);
}

TEST(Cylinder, IsClosedAndFacesOutwards) {
    const Mesh mesh = cylinder({1, 2, 3}, 2.0f, 5.0f, 96, 0);
    expectNormalsAlongFacets(mesh);
    EXPECT_TRUE(closed(meshEdges(mesh)));
    EXPECT_NEAR(signedVolume(mesh), kPi * 20.0, 2e-3 * kPi * 20.0);
}

TEST(Torus, IsClosedAndFacesOutwards) {
    const Mesh mesh = torus({0, 2, 0}, 1.0f, 0.25f, 64, 32, 0);
    expectNormalsAlongFacets(mesh);
    EXPECT_TRUE(closed(meshEdges(mesh)));
    const double exact = 2.0 * kPi * kPi * 0.25 * 0.25;
    EXPECT_NEAR(signedVolume(mesh), exact, 0.01 * exact);  // 32-gon: 0.6 % less than the disk
}

TEST(Arch, IsClosedAndStandsOnItsFeet) {
    const Mesh mesh = arch({0, 1, 0}, 1.0f, 1.5f, 0.4f, 64, 0);
    expectNormalsAlongFacets(mesh);
    EXPECT_TRUE(closed(meshEdges(mesh)));
    const double exact = 0.5 * kPi * (1.5 * 1.5 - 1.0) * 0.4;
    EXPECT_NEAR(signedVolume(mesh), exact, 1e-3 * exact);
    EXPECT_EQ(bounds(mesh).lower, glm::vec3(-1.5f, 1, -0.2f));
}

TEST(Append, ShiftsIndices) {
    Mesh mesh = ground(1.0f, 1, 2);
    append(mesh, box({0, 0, 0}, {1, 1, 1}, 0));
    EXPECT_EQ(mesh.positions.size(), 28u);
    EXPECT_EQ(mesh.triangles[2].x, 4u);
    EXPECT_EQ(mesh.material, 2);
}

}  // namespace
}  // namespace penumbra
