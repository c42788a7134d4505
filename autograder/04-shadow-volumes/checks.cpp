// Shadow volumes: which triangles face the light, where volumes have sides, and where their twins
// lie. Whole numbers and exact signs first.
#include <algorithm>

#include "volume_checks.h"

namespace penumbra {
namespace {

const std::string kExact = "whole numbers and an exact sign: none may differ";

std::vector<int> ones(const std::vector<int>& signs) {
    std::vector<int> facing;
    for (const int sign : signs) facing.push_back(sign > 0 ? 1 : 0);
    return facing;
}

std::vector<Light> lightsAround() {
    return {lampAt({3, 5, 2}), sunFrom({3, 5, 2}),
            lampAt({-4, 2, 1}),  // in the plane of one of the box's faces
            sunFrom({0.5f, -6, 3})};
}

std::vector<Mesh> closedMeshes() {
    return {box({-1, -1, -1}, {1, 1, 1}, 0), sphere({0, 0, 0}, 1.2f, 12, 0),
            torus({0, 0, 0}, 1.0f, 0.4f, 24, 12, 0), potato(5)};
}

// --- Task 1 ---

TEST(Task1Silhouette, ATriangleFacesTheLightThatSeesItCounterClockwise) {
    for (const Light& light : lightsAround()) {
        const Stage stage = staged(closedMeshes(), {light});
        const std::vector<MeshLists> lists = listsOf(stage);
        for (std::size_t i = 0; i < lists.size(); ++i)
            expectEqualLists("facingTriangles()", lists[i].facing,
                             ones(sidesOfLight(stage.scene.meshes[i], stage.light())), kExact);
    }
}

// Whole numbers up to a few thousand: every product of the determinant has less than 53 bits, so
// float64 gives its exact sign, but float32 does not.
TEST(Task1Silhouette, NearlyInAPlaneTheSignIsExact) {
    Dice dice{std::mt19937(17)};
    std::vector<vec3> corners;
    std::vector<int> truth;
    const vec3 light = dice.lattice(3000);
    while (truth.size() < 256) {
        // In the light's own plane, and one step beside it.
        const vec3 u = dice.lattice(1500), v = dice.lattice(1500);
        const vec3 beside(std::round(dice(-1.49, 1.49)), 0, 0);
        const vec3 a = light + u, b = light + v + beside, c = light - u - v;
        const dvec3 n = glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
        const double side = glm::dot(n, dvec3(light) - dvec3(a));
        corners.insert(corners.end(), {a, b, c});
        truth.push_back(side > 0 ? 1 : 0);
    }
    const Stage stage = staged({triangleMesh(corners)}, {lampAt(light)});
    expectEqualLists("facingTriangles()", listsOf(stage)[0].facing, truth, kExact);
}

TEST(Task1Silhouette, ALightInATrianglesPlaneDoesNotSeeIt) {
    // The light lies in the planes of a box's faces; for the sun they are parallel to it.
    for (const Light& light : {lampAt({1, 3, 0}), lampAt({1, 1, 5}), sunFrom({0, 1, 0})}) {
        const Stage stage = staged({box({-1, -1, -1}, {1, 1, 1}, 0)}, {light});
        expectEqualLists("facingTriangles()", listsOf(stage)[0].facing,
                         ones(sidesOfLight(stage.scene.meshes[0], stage.light())), kExact);
    }
}

TEST(Task1Silhouette, ATriangleWithoutAreaFacesNothing) {
    const vec3 a(0, 0, 0), b(1, 0.25f, 0), c(0.5f, 0.125f, 0), d(0, 0, 1);
    const Stage stage = staged({triangleMesh({a, a, a, a, a, b, a, b, c, b, a, c, b, a, d})},
                               {lampAt({0.3f, 4, 0.3f})});
    expectEqualLists("facingTriangles()", listsOf(stage)[0].facing,
                     ones(sidesOfLight(stage.scene.meshes[0], stage.light())), kExact);
}

// Worked out from the triangles alone.
std::vector<int> boundaryOf(const Mesh& mesh, const MeshLists& lists) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto from = lists.edges.welded[mesh.triangles[t][k]];
            const auto to = lists.edges.welded[mesh.triangles[t][(k + 1) % 3]];
            runs[{from, to}] += lists.weights[t];
        }
    std::vector<int> sums;
    for (const MeshEdge& edge : lists.edges.edges)
        sums.push_back(runs[{edge.from, edge.to}] - runs[{edge.to, edge.from}]);
    return sums;
}

void expectEdgeSums(const Stage& stage) {
    const std::vector<MeshLists> lists = listsOf(stage);
    int silhouettes = 0;
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const std::vector<int> truth = boundaryOf(stage.scene.meshes[i], lists[i]);
        silhouettes += int(truth.size() - std::size_t(std::count(truth.begin(), truth.end(), 0)));
        expectEqualLists("edgeSums()", lists[i].edgeSums, truth,
                         "sum of weights, each by the direction in which its triangle runs");
    }
    EXPECT_VALUE(silhouettes, Greater, 0, "edges at which the weights do not cancel");
}

TEST(Task1Silhouette, EdgesSumTheirTrianglesByDirection) {
    for (const Light& light : lightsAround()) expectEdgeSums(staged(closedMeshes(), {light}));
}

TEST(Task1Silhouette, AnEdgeMayHaveOneTriangleOrThree) {
    expectEdgeSums(staged(loadScene("open_mesh")));
    // Two triangles that run along their common edge in one direction: twice the same side.
    const vec3 a(0, 1, 0), b(0, 1, 2);
    expectEdgeSums(
        staged({triangleMesh({a, b, {1, 1, 1}, a, b, {2, 0.5f, 1}})}, {lampAt({0, 5, 1})}));
}

TEST(Task1Silhouette, SilhouettesOfClosedMeshesAreLoops) {
    for (const Light& light : lightsAround()) {
        const std::vector<MeshLists> lists = listsOf(staged(closedMeshes(), {light}));
        for (const MeshLists& mesh : lists) {
            std::map<std::uint32_t, int> entered;  // less left
            int edges = 0, largest = 0, torn = 0;
            for (std::size_t i = 0; i < mesh.edgeSums.size(); ++i) {
                const int sum = mesh.edgeSums[i];
                entered[mesh.edges.edges[i].to] += sum, entered[mesh.edges.edges[i].from] -= sum;
                edges += sum != 0, largest = std::max(largest, std::abs(sum));
            }
            for (const auto& [vertex, times] : entered) torn += times != 0;
            EXPECT_VALUE(edges, Greater, 2, "a loop has three edges or more");
            EXPECT_VALUE(largest, LessOrEqual, 1,
                         "two triangles meet at an edge, one of them faces");
            EXPECT_VALUE(torn, Equal, 0, "vertices that are not entered as often as left");
        }
    }
}

// --- Task 2 ---

struct Pushed {
    Rows points, lights, twins;

    Pushed(const Rows& points, const Rows& lights)
        : points(points),
          lights(lights),
          twins(evaluate({.chunk = "extrude.glsl",
                          .expression = "extruded(a.xyz, b)",
                          .inputs = {{"a", points}, {"b", lights}}})) {}

    // Homogeneous points at infinity are equal up to a positive factor: unit vectors.
    void expectAway(double absolute, const std::string& cause) const {
        Rows measured, truth;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const dvec3 away = double(lights[i].w) * dvec3(points[i]) - dvec3(lights[i]);
            const dvec3 twin(twins[i]);
            const double length = glm::length(twin);
            measured.emplace_back(length > 0 ? twin / length : dvec3(0.0), twins[i].w);
            truth.emplace_back(glm::normalize(away), 0.0);
        }
        expectRowsNear("extruded(), as a unit vector", measured, truth,
                       {.absolute = absolute, .relative = 0, .components = 4, .cause = cause});
    }
};

Rows lattice(unsigned seed, float w, double scale, int count = 256) {
    Dice dice{std::mt19937(seed)};
    Rows rows;
    for (int i = 0; i < count; ++i)
        rows.emplace_back(scale * dice(-8, 8), scale * dice(-8, 8), scale * dice(-8, 8), w);
    return rows;
}

const std::string kOneSubtraction =
    "one float32 product and one difference a component: 2^-24 relative, and a unit vector's";

Rows both(Rows rows, const Rows& more) {
    rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

TEST(Task2Extrude, TwinsLieAtInfinity) {
    const Pushed pushed(lattice(1, 0, 1, 512), both(lattice(2, 0, 1), lattice(2, 1, 1)));
    int finite = 0;
    for (const vec4 twin : pushed.twins)
        finite += twin.w != 0.0f || glm::length(vec3(twin)) == 0.0f;
    EXPECT_VALUE(finite, Equal, 0, "twins with w not 0, or without a direction");
}

TEST(Task2Extrude, ALampPushesAwayFromItself) {
    Pushed(lattice(3, 0, 1), lattice(4, 1, 1)).expectAway(1e-6, kOneSubtraction);
}

TEST(Task2Extrude, TheSunPushesAlongItsRays) {
    Pushed(lattice(5, 0, 1), lattice(6, 0, 1)).expectAway(1e-6, kOneSubtraction);
}

TEST(Task2Extrude, HugeAndTinyScenesArePushedAlike) {
    Rows points, lights;
    for (const double scale : {1e-15, 1e15})
        for (const float w : {0.0f, 1.0f}) {
            points = both(points, lattice(7, 0, scale));
            lights = both(lights, lattice(8, w, scale));
        }
    // A light that touches the mesh, and one that is far away.
    points = both(points, lattice(9, 0, 1));
    for (const vec4 p : lattice(9, 0, 1)) lights.emplace_back(vec3(p) * 1.0001f, 1.0f);
    points = both(points, lattice(10, 0, 1e-3));
    lights = both(lights, lattice(11, 1, 1e6));
    Pushed(points, lights).expectAway(1e-6, kOneSubtraction);
}

}  // namespace
}  // namespace penumbra
