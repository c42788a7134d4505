#include "scene/mesh_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "scene/gallery.h"
#include "scene/orientation.h"
#include "scene/shapes.h"

namespace penumbra {
namespace {

Mesh bare(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    return mesh;
}

void turnInsideOut(Mesh& mesh) {
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
}

// A triangular prism x + y <= 1, 0 <= z <= 2, whose edge from (0,0,0) to (0,0,2) one side splits at
// z = 1 and the other does not.
Mesh prismWithTJunction() {
    return bare({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 1}},
                {{0, 2, 1},  // bottom
                 {3, 4, 5},  // top
                 {0, 1, 4},
                 {0, 4, 3},  // y = 0, with the whole edge
                 {1, 2, 5},
                 {1, 5, 4},  // the slope
                 {2, 0, 6},
                 {2, 6, 5},
                 {5, 6, 3}});  // x = 0, with the halves
}

// The edges of triangles that face the light, each summed: the outline, as a count of its edges.
int silhouetteEdges(const Mesh& mesh, glm::vec4 light) {
    const MeshEdges edges = meshEdges(mesh);
    int count = 0;
    for (const MeshEdge& edge : edges.edges) {
        int sum = 0;
        for (const EdgeSide side : edges.sidesOf(edge)) {
            const glm::uvec3 t = mesh.triangles[side.triangle];
            const int toLight =
                orientation(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], light);
            sum += toLight > 0 ? side.direction : 0;
        }
        count += sum != 0;
    }
    return count;
}

TEST(MeshEdges, OfABoxAreTwelveAndSixDiagonals) {
    const Mesh mesh = box({0, 0, 0}, {1, 2, 3}, 0);
    ASSERT_EQ(mesh.positions.size(), 24u) << "corners are copied for their normals";
    const MeshEdges edges = meshEdges(mesh);
    EXPECT_EQ(edges.edges.size(), 18u);
    EXPECT_EQ(edges.sides.size(), 36u);
    EXPECT_TRUE(closed(edges));
    EXPECT_EQ(meshReport(edges).text(), "closed");
    std::vector<std::uint32_t> corners = edges.welded;
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    EXPECT_EQ(corners.size(), 8u);
    for (std::uint32_t v = 0; v < 24; ++v) {
        EXPECT_LE(edges.welded[v], v);
        EXPECT_EQ(mesh.positions[edges.welded[v]], mesh.positions[v]);
    }
}

TEST(MeshEdges, AreSortedAndListEveryTriangleThrice) {
    const MeshEdges edges = meshEdges(sphere({0, 1, 0}, 1.0f, 8, 0));
    std::vector<int> seen(edges.sides.size() / 3 + edges.degenerate.size(), 0);
    for (std::size_t i = 0; i < edges.edges.size(); ++i) {
        const MeshEdge& edge = edges.edges[i];
        EXPECT_LT(edge.from, edge.to);
        if (i > 0) {
            EXPECT_LT(std::pair(edges.edges[i - 1].from, edges.edges[i - 1].to),
                      std::pair(edge.from, edge.to));
        }
        const auto sides = edges.sidesOf(edge);
        ASSERT_EQ(sides.size(), 2u);
        EXPECT_LT(sides[0].triangle, sides[1].triangle);
        EXPECT_EQ(sides[0].direction, -sides[1].direction);
        for (const EdgeSide side : sides) ++seen[side.triangle];
    }
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 3; }));
}

TEST(MeshEdges, DirectionTellsWhichWayTheTriangleRuns) {
    const MeshEdges edges = meshEdges(bare({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 1}}));
    ASSERT_EQ(edges.edges.size(), 3u);
    const auto direction = [&](std::size_t i) {
        return edges.sidesOf(edges.edges[i])[0].direction;
    };
    EXPECT_EQ(direction(0), -1) << "0 1: the triangle runs 1 -> 0";
    EXPECT_EQ(direction(1), +1) << "0 2";
    EXPECT_EQ(direction(2), -1) << "1 2: the triangle runs 2 -> 1";
}

TEST(MeshEdges, WeldPositionsThatAreEqualAndNoOthers) {
    const float next = std::nextafter(1.0f, 2.0f);
    const MeshEdges edges =
        meshEdges(bare({{0, 0, 0}, {1, 0, 0}, {-0.0f, 0, 0}, {next, 0, 0}, {1, 0, 0}}, {}));
    EXPECT_EQ(edges.welded, (std::vector<std::uint32_t>{0, 1, 0, 3, 1}));
}

TEST(MeshEdges, SilhouetteOfABoxHasFourOrSixEdges) {
    const Mesh mesh = box({-1, -1, -1}, {1, 1, 1}, 0);
    EXPECT_EQ(silhouetteEdges(mesh, {0, 9, 0, 1}), 4);
    EXPECT_EQ(silhouetteEdges(mesh, {4, 9, 0, 1}), 6) << "two faces";
    EXPECT_EQ(silhouetteEdges(mesh, {4, 9, 5, 1}), 6) << "three faces";
    EXPECT_EQ(silhouetteEdges(mesh, {1, 2, 3, 0}), 6) << "directional";
    EXPECT_EQ(silhouetteEdges(mesh, {0, 9, 1, 1}), 4) << "in the plane of a face: not facing";
    EXPECT_EQ(silhouetteEdges(mesh, {0, 0, 0, 1}), 0) << "from inside nothing faces the light";
}

TEST(Closed, GroundHasABorder) {
    const MeshReport report = meshReport(meshEdges(ground(4.0f, 2, 0)));
    EXPECT_FALSE(report.closed());
    EXPECT_EQ(report.openEdges, 8u);
    EXPECT_EQ(report.text(), "not closed: 8 edges of one triangle");
}

TEST(Closed, ThreeFacesOnAnEdgeAreNot) {
    const MeshEdges edges =
        meshEdges(bare({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 1}, {-1, 0, -1}},
                       {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
    EXPECT_FALSE(closed(edges));
    EXPECT_EQ(edges.sidesOf(edges.edges[0]).size(), 3u);
    EXPECT_EQ(meshReport(edges).text(),
              "not closed: 6 edges of one triangle, 1 edge of an odd number of triangles");
}

TEST(Closed, FourFacesOnAnEdgeMayBe) {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1}, 0);
    append(mesh, box({1, 0, 1}, {2, 1, 2}, 0));  // they touch along x = z = 1
    const MeshEdges edges = meshEdges(mesh);
    EXPECT_TRUE(closed(edges));
    EXPECT_EQ(edges.edges.size(), 35u);
    EXPECT_EQ(std::count_if(edges.edges.begin(), edges.edges.end(),
                            [](const MeshEdge& edge) { return edge.sideCount == 4; }),
              1);
}

TEST(Closed, NeighboursWoundAlikeAreNot) {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1}, 0);
    std::swap(mesh.triangles[5].x, mesh.triangles[5].y);
    EXPECT_EQ(meshReport(meshEdges(mesh)).text(),
              "not closed: 3 edges whose triangles are wound alike");
}

TEST(Closed, TJunctionShowsAsOpenEdgesThatAFlatTriangleCloses) {
    Mesh mesh = prismWithTJunction();
    EXPECT_EQ(meshReport(meshEdges(mesh)).openEdges, 3u) << "the whole edge and its halves";
    mesh.triangles.push_back({0, 3, 6});  // no area, but three corners and three edges
    const MeshEdges edges = meshEdges(mesh);
    EXPECT_TRUE(closed(edges));
    EXPECT_TRUE(edges.degenerate.empty());
    EXPECT_NEAR(signedVolume(mesh), 1.0, 1e-12);
}

TEST(Closed, DegenerateTrianglesAreLeftOut) {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1}, 0);
    const auto before = meshEdges(mesh).edges.size();
    mesh.triangles.push_back({0, 0, 5});
    mesh.triangles.push_back({7, 2, 7});
    mesh.positions.push_back(mesh.positions[3]);  // another index, the same place
    mesh.triangles.push_back({3, 8, 24});
    const MeshEdges edges = meshEdges(mesh);
    EXPECT_EQ(edges.degenerate, (std::vector<std::uint32_t>{12, 13, 14}));
    EXPECT_EQ(edges.edges.size(), before);
    EXPECT_TRUE(closed(edges));
    EXPECT_EQ(meshReport(edges).text(), "closed (3 of 15 triangles without area left out)");
    EXPECT_TRUE(closed(meshEdges(Mesh{})));
}

TEST(WindingNumber, CountsSolidsAroundAPoint) {
    Mesh mesh = box({-1, -1, -1}, {1, 1, 1}, 0);
    for (const glm::vec3 p : {glm::vec3(0), glm::vec3(0.999f, 0, 0), glm::vec3(-0.9f, 0.9f, 0.9f)})
        EXPECT_EQ(windingNumber(mesh, p), 1);
    for (const glm::vec3 p : {glm::vec3(1.001f, 0, 0), glm::vec3(0, 8, 0), glm::vec3(1, 1, 2)})
        EXPECT_EQ(windingNumber(mesh, p), 0);
    append(mesh, box({0, 0, 0}, {3, 3, 3}, 0));
    EXPECT_EQ(windingNumber(mesh, {0.5f, 0.5f, 0.5f}), 2);
    turnInsideOut(mesh);
    EXPECT_EQ(windingNumber(mesh, {0.5f, 0.5f, 0.5f}), -2);
    EXPECT_EQ(windingNumber(mesh, {-0.5f, 0.5f, 0.5f}), -1);
}

TEST(WindingNumber, AHollowIsOutside) {
    Mesh mesh = sphere({0, 0, 0}, 2.0f, 12, 0), inner = sphere({0, 0, 0}, 1.0f, 12, 0);
    turnInsideOut(inner);
    append(mesh, inner);
    EXPECT_EQ(windingNumber(mesh, {0, 0.1f, 0}), 0);
    EXPECT_EQ(windingNumber(mesh, {0, 1.5f, 0}), 1);
    EXPECT_EQ(windingNumber(mesh, {0, 2.5f, 0}), 0);
}

TEST(SignedVolume, IsThatOfTheSolid) {
    Mesh mesh = box({1, 1, 1}, {2, 3, 4}, 0);
    EXPECT_NEAR(signedVolume(mesh), 6.0, 1e-12);
    turnInsideOut(mesh);
    EXPECT_NEAR(signedVolume(mesh), -6.0, 1e-12);
}

TEST(FacingTrianglesSuffice, ForClosedMeshesThatDoNotHoldTheLight) {
    Mesh mesh = box({-1, -1, -1}, {1, 1, 1}, 0);
    const MeshEdges edges = meshEdges(mesh);
    EXPECT_TRUE(facingTrianglesSuffice(mesh, edges, {0, 8, 0, 1}));
    EXPECT_TRUE(facingTrianglesSuffice(mesh, edges, {0, 1, 0, 0})) << "directional: never inside";
    EXPECT_FALSE(facingTrianglesSuffice(mesh, edges, {0, 0.5f, 0, 1})) << "inside";
    const Mesh open = ground(2.0f, 1, 0);
    EXPECT_FALSE(facingTrianglesSuffice(open, meshEdges(open), {0, 8, 0, 1}));
    turnInsideOut(mesh);
    EXPECT_FALSE(facingTrianglesSuffice(mesh, meshEdges(mesh), {0, 8, 0, 1})) << "inside out";
}

TEST(InstalledModels, WindingOfTheirClosedMeshesIsZeroFarAway) {
    int meshes = 0, closedMeshes = 0;
    for (const std::string& name : installedModelNames()) {
        const Scene scene = loadScene(name);
        for (const Mesh& mesh : scene.meshes) {
            const MeshEdges edges = meshEdges(mesh);
            ++meshes;
            EXPECT_EQ(closed(edges), meshReport(edges).closed());
            if (!closed(edges)) continue;
            ++closedMeshes;
            EXPECT_EQ(windingNumber(mesh, bounds(scene).upper + 1.0f), 0) << name;
        }
    }
    if (meshes == 0) GTEST_SKIP() << "no models are installed";
    RecordProperty("meshes", meshes);
    RecordProperty("closed", closedMeshes);
}

TEST(ClosedTriangles, AreThoseOfPartsWithoutABorder) {
    Mesh mesh = ground(4.0f, 2, 0);
    append(mesh, box({0, 0, 0}, {1, 1, 1}, 0));
    append(mesh, ground(1.0f, 1, 0));
    std::vector<std::uint32_t> box(12);
    std::iota(box.begin(), box.end(), 8u);
    EXPECT_EQ(closedTriangles(mesh, meshEdges(mesh)), box);
    turnInsideOut(mesh);
    EXPECT_EQ(closedTriangles(mesh, meshEdges(mesh)), box);
}

TEST(ClosedTriangles, OfAPrismWithATJunctionAreNone) {
    Mesh mesh = prismWithTJunction();
    EXPECT_TRUE(closedTriangles(mesh, meshEdges(mesh)).empty());
    mesh.triangles.push_back({0, 3, 6});  // no area, but it closes the gap
    mesh.triangles.push_back({0, 3, 3});  // no edges: no part of anything
    EXPECT_EQ(closedTriangles(mesh, meshEdges(mesh)).size(), 10u);
}

}  // namespace
}  // namespace penumbra
