// Shadow volumes: sides, and meshes that need all their triangles.
#include "volume_checks.h"

namespace penumbra {
namespace {

// --- Task 5 ---

// A side's boundary is the silhouette edge (backwards: it is the neighbour round the corner), two
// rays to infinity and the twins' edge. With two triangles for each that leaves its diagonal free
// and nothing else.
void expectSides(const Stage& stage, bool sunlit) {
    const std::vector<MeshLists> meshes = listsOf(stage);
    int total = 0;
    for (const MeshLists& mesh : meshes) {
        Boundary mine, exact;
        int sides = 0;
        for (std::size_t i = 0; i < mesh.edgeSums.size(); ++i) {
            const int sum = mesh.edgeSums[i];
            const int from = int(mesh.edges.edges[i].from), to = int(mesh.edges.edges[i].to);
            sides += std::abs(sum);
            addEdge(exact, {to, false}, {from, false}, sum, sunlit);
            addEdge(exact, {from, false}, {from, true}, sum, sunlit);
            addEdge(exact, {from, true}, {to, true}, sum, sunlit);
            addEdge(exact, {to, true}, {to, false}, sum, sunlit);
        }
        total += sides;
        addBoundary(mine, mesh.sides, 1, sunlit);
        EXPECT_VALUE(differences(mine, exact), Equal, 0,
                     "edges that sides run along too often, too rarely or the wrong way");
        EXPECT_VALUE(mesh.sides.size(), Equal, (sunlit ? 1 : 2) * sides,
                     sunlit ? "one triangle for each side" : "two triangles for each side");
    }
    EXPECT_VALUE(total, Greater, 0, "edges whose sum is not 0");
}

const vec3 kAside(2.5f, 7, 3);

TEST(Task5Sides, SidesOfClosedMeshesFaceOut) {
    const std::vector<Mesh> meshes{box({-1, -1, -1}, {1, 1, 1}, 0),
                                   torus({0, 0, 0}, 1.0f, 0.4f, 24, 12, 0), potato(5)};
    expectSides(staged(meshes, {lampAt(kAside)}), false);
    expectSides(staged(meshes, {lampAt(-kAside)}), false);
}

TEST(Task5Sides, TheSunsSidesEndInOnePoint) {
    const std::vector<Mesh> meshes{box({-1, -1, -1}, {1, 1, 1}, 0), potato(6)};
    expectSides(staged(meshes, {sunFrom(kAside)}), true);
    expectSides(staged(meshes, {sunFrom(-kAside)}), true);
}

TEST(Task5Sides, AnEdgeThatCountsTwiceHasTwoSides) {
    const vec3 a(0, 1, 0), b(0, 1, 2);
    const Mesh twice = triangleMesh({a, b, {1, 1, 1}, a, b, {2, 0.5f, 1}});
    expectSides(staged({twice}, {lampAt({0.1f, 5, 1})}), false);
    expectSides(staged({insideOut(twice)}, {lampAt({0.1f, -5, 1})}), false);
}

// --- Task 6 ---

struct Specimen {
    const char* what;
    Mesh mesh;
    bool all;  // needs all its triangles
};

Mesh together(Mesh mesh, Mesh other) {
    mesh.uvs.clear(), other.uvs.clear();
    append(mesh, other);
    return mesh;
}

// Around the light at the origin, or not.
std::vector<Specimen> specimens() {
    const Mesh aside = box({2, -1, -1}, {4, 1, 1}, 0), around = box({-3, -3, -3}, {3, 3, 3}, 0);
    Mesh faceTurned = aside;
    for (std::size_t i : {0, 1}) std::swap(faceTurned.triangles[i].y, faceTurned.triangles[i].z);
    const Mesh sheet = triangleMesh({{2, 0, 0}, {2, 1, 0}, {2, 0, 1}});
    const Mesh ring = torus({0, 0, 0}, 2.0f, 0.4f, 24, 12, 0);
    const vec3 foot(2, -1, 0), top(2, 1, 0);
    return {
        {"a closed box beside the light", aside, false},
        {"the same inside out", insideOut(aside), true},
        {"a box without a triangle", withoutTriangle(aside, 7), true},
        {"a box with one face turned round", faceTurned, true},
        {"a sheet", sheet, true},
        {"a sheet and its back", together(sheet, insideOut(sheet)), false},
        {"three sails on one edge",
         triangleMesh({foot, top, {3, 0, 1}, foot, top, {3, 0, -1}, foot, top, {4, 0, 0.2f}}),
         true},
        {"two fans of one edge, wound alike",
         triangleMesh({foot, top, {3, 0, 1}, foot, top, {3, 0, -1}}), true},
        {"a T-junction",
         triangleMesh({{2, 0, 0},
                       {2, 2, 0},
                       {2, 1, 1},
                       {2, 1, 0},
                       {2, 0, 0},
                       {2, 0, -1},
                       {2, 2, 0},
                       {2, 1, 0},
                       {2, 2, -1}}),
         true},
        {"two boxes that share an edge",
         together(box({2, 0, 0}, {3, 1, 1}, 0), box({3, 1, 0}, {4, 2, 1}, 0)), false},
        {"a closed box and a triangle without area",
         together(aside, triangleMesh({{2, 2, 2}, {2, 2, 2}, {3, 2, 2}})), false},
        {"the light in the box", around, true},
        {"the light in the hole of a ring", ring, false},
        {"the light in two boxes", together(around, box({-2, -2, -2}, {2, 2, 2}, 0)), true},
        {"the light in the hollow of a shell",
         together(around, insideOut(box({-2, -2, -2}, {2, 2, 2}, 0))), false},
        {"no triangles", triangleMesh({{5, 0, 0}, {5, 0, 0}, {5, 0, 0}}), false},
    };
}

Stage shelf(const Light& light) {
    std::vector<Mesh> meshes;
    for (const Specimen& specimen : specimens()) meshes.push_back(specimen.mesh);
    return staged(std::move(meshes), {light});
}

TEST(Task6OpenMeshes, MeshesThatNeedAllTheirTrianglesAreKnown) {
    const std::vector<MeshLists> lists = listsOf(shelf(lampAt({0, 0, 0})));
    const std::vector<Specimen> all = specimens();
    for (std::size_t i = 0; i < all.size(); ++i)
        expectValue("needsAllTriangles()", lists[i].kind, Relation::Equal, all[i].all, all[i].what);
}

TEST(Task6OpenMeshes, TheSunIsInNoMesh) {
    const std::vector<MeshLists> lists = listsOf(shelf(sunFrom({1, 4, 2})));
    const std::vector<Specimen> all = specimens();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const MeshEdges edges = meshEdges(all[i].mesh);
        const bool needs = !closed(edges) || signedVolume(all[i].mesh) < 0;
        expectValue("needsAllTriangles()", lists[i].kind, Relation::Equal, needs, all[i].what);
    }
}

TEST(Task6OpenMeshes, EveryTriangleCountsOnceTurnedToTheLight) {
    for (const Light& light : {lampAt({0, 0, 0}), sunFrom({1, 4, 2})}) {
        const Stage stage = shelf(light);
        // Asked for by the setting: whatever needsAllTriangles() says.
        const std::vector<MeshLists> lists = listsOf(stage, {"volumes=per_triangle"});
        for (std::size_t i = 0; i < lists.size(); ++i)
            expectEqualLists("allTriangles()", lists[i].weights,
                             sidesOfLight(stage.scene.meshes[i], stage.light()),
                             "the sign of orientation(): none may differ");
    }
}

TEST(Task6OpenMeshes, CountsOfOpenMeshesEqualCrossings) {
    expectCounts("open_mesh", {});
    expectCounts("open_mesh@2", {"method=zpass"});
}

TEST(Task6OpenMeshes, CountsOfLeavesEqualCrossings) {
    expectCounts("foliage", {},
                 {2,
                  "leaves with an edge to the light: their volume is thinner than the half pixel "
                  "within which sides are left out; 1 measured"});
}

TEST(Task6OpenMeshes, TheLightMayBeInAMesh) {
    expectCounts("shut_lamp", {});
    expectCounts("lamp", {});
}

// Holes, walls without thickness, and one box inside out, all seen from within and without.
TEST(Task6OpenMeshes, BrokenSolidsShadeLikeTheirTriangles) {
    Scene scene = loadScene("boxes");
    scene.meshes.resize(1);  // the ground
    Mesh shell = sphere({-1.2f, 1.3f, 0.4f}, 0.9f, 12, 0);
    for (std::size_t i = 0; i < 40; ++i) shell = withoutTriangle(std::move(shell), 37);
    const Mesh solid = box({0.8f, 0.3f, -0.9f}, {1.9f, 1.2f, 0.3f}, 0);
    Mesh lid = insideOut(box({0.9f, 1.5f, 0.6f}, {1.9f, 2.0f, 1.5f}, 0));
    scene.meshes.insert(scene.meshes.end(), {shell, solid, lid});
    for (Mesh& mesh : scene.meshes) mesh.uvs.clear();
    expectCounts(sceneFile(scene), {});
}

TEST(Task6OpenMeshes, VolumesOfSingleTrianglesCountAlike) {
    expectCounts("open_mesh@2", {"volumes=per_triangle"},
                 {4, "neighbours' sides cancel only where both are rasterised alike"});
}

}  // namespace
}  // namespace penumbra
