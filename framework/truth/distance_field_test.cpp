#include "truth/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "scene/gallery.h"
#include "scene/mesh_edges.h"
#include "scene/random.h"
#include "scene/shapes.h"
#include "truth/parallel.h"
#include "truth/test_scene.h"

namespace penumbra {

using namespace testing;

namespace {

Mesh insideOut(Mesh mesh) {
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

DistanceField fieldOf(const std::vector<Mesh>& meshes, int voxels) {
    return distanceField(meshes, DistanceGrid::around(bounds(meshes), voxels));
}

template <class Visit>
void forEachVoxel(const DistanceGrid& grid, Visit visit) {
    for (int k = 0; k < grid.size.z; ++k)
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i) visit(glm::ivec3(i, j, k));
}

// Of a box, in closed form.
double boxDistance(glm::dvec3 p, glm::dvec3 lower, glm::dvec3 upper) {
    const glm::dvec3 out = glm::max(lower - p, p - upper);
    const double nearestFace = std::max({out.x, out.y, out.z});
    return nearestFace > 0.0 ? glm::length(glm::max(out, 0.0)) : nearestFace;
}

// Projection on each triangle by the sign tests of barycentrics [Ericson 2005, section 5.1.5]: a
// second way, and no tree.
double bruteForce(const std::vector<Mesh>& meshes, glm::dvec3 p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Mesh& mesh : meshes)
        for (const glm::uvec3 t : mesh.triangles) {
            const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
            const glm::dvec3 ab = b - a, ac = c - a;
            const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
            const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
            const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
            const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
            glm::dvec3 nearest;
            if (d1 <= 0 && d2 <= 0)
                nearest = a;
            else if (d3 >= 0 && d4 <= d3)
                nearest = b;
            else if (vc <= 0 && d1 >= 0 && d3 <= 0)
                nearest = a + d1 / (d1 - d3) * ab;
            else if (d6 >= 0 && d5 <= d6)
                nearest = c;
            else if (vb <= 0 && d2 >= 0 && d6 <= 0)
                nearest = a + d2 / (d2 - d6) * ac;
            else if (va <= 0 && d4 >= d3 && d5 >= d6)
                nearest = b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
            else
                nearest = a + (vb * ab + vc * ac) / (va + vb + vc);
            least = std::min(least, glm::distance(p, nearest));
        }
    return least;
}

TEST(DistanceGrid, HoldsTheBoxWithItsPadding) {
    for (const Box box :
         {Box{{-1, 0, 2}, {3, 1, 2.5f}}, Box{{1e6f, -1e6f, 0}, {1e6f + 1, -1e6f + 2, 1}},
          Box{{0.1f, 0.2f, 0.3f}, {0.7f, 0.9f, 1.1f}}, Box{{5, 5, 5}, {6, 5, 5}}})
        for (const int voxels : {5, 64, 128, 256}) {
            const DistanceGrid grid = DistanceGrid::around(box, voxels);
            EXPECT_EQ(std::max({grid.size.x, grid.size.y, grid.size.z}), voxels);
            for (int axis = 0; axis < 3; ++axis) {
                const double upper = grid.lower[axis] + double(grid.size[axis]) * grid.cell;
                EXPECT_GE(box.lower[axis] - double(grid.lower[axis]), 2.0 * grid.cell) << axis;
                EXPECT_GE(upper - box.upper[axis], 2.0 * grid.cell) << axis;
            }
        }
}

TEST(DistanceGrid, AroundNothingIsAnError) {
    EXPECT_THROW(DistanceGrid::around({}, 64), Error);
    EXPECT_THROW(DistanceGrid::around({{1, 2, 3}, {1, 2, 3}}, 64), Error);
}

TEST(DistanceField, OfABoxIsTheClosedForm) {
    const glm::vec3 lower(-1, 0, 0.5f), upper(1.5f, 1, 1.25f);
    const DistanceField field = fieldOf({box(lower, upper, 0)}, 32);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const double truth = boxDistance(field.grid.center(v), lower, upper);
        EXPECT_NEAR(field.at(v), truth, 1e-7 * std::abs(truth) + 1e-15);  // float32 rounding
    });
}

TEST(DistanceField, OfABoxInsideOutIsTheSame) {
    const Mesh cube = box({-1, 0, 0.5f}, {1.5f, 1, 1.25f}, 0);
    EXPECT_EQ(fieldOf({insideOut(cube)}, 24).values, fieldOf({cube}, 24).values);
}

// Rows and slices of voxels run along faces, edges, diagonals and through corners of the box.
TEST(DistanceField, IsRightWhereCentresLieOnFacesEdgesAndCorners) {
    for (const bool turned : {false, true}) {
        const glm::vec3 lower(-1, -0.5f, 0), upper(1, 1, 1.5f);
        const Mesh cube = box(lower, upper, 0);
        const DistanceGrid grid{glm::vec3(-1.625f), 0.25f, glm::ivec3(14)};
        const DistanceField field =
            distanceField(std::vector{turned ? insideOut(cube) : cube}, grid);
        int zeros = 0;
        forEachVoxel(grid, [&](glm::ivec3 v) {
            const double truth = boxDistance(grid.center(v), lower, upper);
            EXPECT_EQ(field.at(v), float(truth));
            EXPECT_EQ(std::signbit(field.at(v)), truth < 0.0);
            zeros += truth == 0.0;
        });
        EXPECT_GT(zeros, 200);
    }
}

// The octahedron's corners, edges and the planes of its faces lie on rows, too, but aslant.
TEST(DistanceField, IsRightOnTheDiagonalsOfAnOctahedron) {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (unsigned x : {0u, 1u})
        for (unsigned y : {2u, 3u})
            for (unsigned z : {4u, 5u})
                mesh.triangles.push_back((x + y + z) % 2 == 0 ? glm::uvec3(x, y, z)
                                                              : glm::uvec3(x, z, y));
    ASSERT_TRUE(closed(meshEdges(mesh)));
    const DistanceGrid grid{glm::vec3(-1.3125f), 0.125f, glm::ivec3(21)};
    const DistanceField field = distanceField(std::vector{mesh}, grid);
    forEachVoxel(grid, [&](glm::ivec3 v) {
        const glm::dvec3 p = glm::abs(grid.center(v));
        const double plane = p.x + p.y + p.z - 1.0;
        EXPECT_EQ(std::signbit(field.at(v)), plane < 0.0);
        if (plane <= 0.0) {
            EXPECT_NEAR(field.at(v), plane / std::sqrt(3.0), 1e-7);
        }
    });
}

TEST(DistanceField, OfASphereIsThatOfItsPolyhedron) {
    const glm::vec3 center(0.3f, -0.2f, 0.1f);
    constexpr unsigned kRings = 24;
    const std::vector<Mesh> meshes{sphere(center, 1.0f, kRings, 0)};
    const DistanceField field = fieldOf(meshes, 48);
    // A facet spans π/rings both ways; its deepest point lies at most half a diagonal off a corner.
    const double sagitta = 1.0 - std::cos(std::sqrt(0.5) * 3.1415926536 / kRings);
    Random random(1);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const glm::dvec3 p = field.grid.center(v);
        const double value = field.at(v), round = glm::distance(p, glm::dvec3(center)) - 1.0;
        EXPECT_GE(value, round - 1e-6);  // float32 rounding of corners
        EXPECT_LE(value, round + sagitta + 1e-6);
        if (random.unit() > 0.02f) return;
        const double truth = bruteForce(meshes, p);
        EXPECT_NEAR(std::abs(value), truth, 1e-7 * truth);
    });
}

TEST(DistanceField, OfAnOpenTriangleHasNoSign) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0.25f, 0}, {0.25f, 1, 0.5f}};
    mesh.triangles = {{0, 1, 2}};
    const DistanceField field = fieldOf({mesh}, 24);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const double truth = bruteForce({mesh}, field.grid.center(v));
        EXPECT_NEAR(field.at(v), truth, 1e-7 * truth);
    });
}

TEST(DistanceField, OfNestedAndOverlappingSolidsIsInsideAny) {
    const std::vector<Mesh> meshes{box({0, 0, 0}, {4, 4, 4}, 0), box({1, 1, 1}, {2, 2, 2}, 0),
                                   insideOut(box({3, 1, 1}, {6, 3, 3}, 0))};
    const DistanceField field = fieldOf(meshes, 40);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const glm::dvec3 p = field.grid.center(v);
        const bool inside =
            boxDistance(p, {0, 0, 0}, {4, 4, 4}) < 0 || boxDistance(p, {3, 1, 1}, {6, 3, 3}) < 0;
        const double truth = bruteForce(meshes, p);
        EXPECT_NEAR(field.at(v), inside ? -truth : truth, 1e-7 * truth);
    });
}

TEST(DistanceField, OfAHollowBodyIsOutsideInItsCavity) {
    Mesh mesh = box({0, 0, 0}, {4, 4, 4}, 0);
    append(mesh, insideOut(box({1, 1, 1}, {3, 3, 3}, 0)));
    const DistanceField field = fieldOf({mesh}, 40);
    EXPECT_GT(field.sample({2, 2, 2}), 0.9f);
    EXPECT_LT(field.sample({0.5f, 2, 2}), -0.4f);
}

TEST(DistanceField, KnowsTheInsideOfTheClosedPartsOfAnOpenMesh) {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1}, 0);
    append(mesh, quad({2, 0, 0}, {3, 0, 0}, {3, 0, 1}, {2, 0, 1}, 0));
    const DistanceField field = fieldOf({mesh}, 48);
    EXPECT_LT(field.sample({0.5f, 0.5f, 0.5f}), -0.4f);
    EXPECT_GT(field.sample({2.5f, -0.03f, 0.5f}), 0.0f);
    EXPECT_GT(field.sample({2.5f, 0.03f, 0.5f}), 0.0f);
}

// A cube whose top is split on one side only. With a triangle of no area in the gap it is closed.
TEST(DistanceField, OfATJunctionHasASignOnceTheGapIsClosed) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5},
                      {1, 5, 4}, {2, 0, 6}, {2, 6, 5}, {5, 6, 3}};
    const DistanceField open = fieldOf({mesh}, 32);
    EXPECT_GT(*std::min_element(open.values.begin(), open.values.end()), 0.0f);
    mesh.triangles.push_back({0, 3, 6});
    mesh.triangles.push_back({2, 2, 6});  // two corners at one place: has no edges
    const DistanceField field = fieldOf({mesh}, 32);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const glm::dvec3 p = field.grid.center(v);
        const double depth =
            std::min({p.x, p.y, p.z, 2.0 - p.z, (1.0 - p.x - p.y) / std::sqrt(2.0)});
        EXPECT_EQ(field.at(v) < 0.0f, depth > 0.0);
        if (depth > 0.0) {
            EXPECT_NEAR(field.at(v), -depth, 1e-7);
        }
    });
}

TEST(DistanceField, OfAThinSlabIsExactAtVoxelCentres) {
    const glm::vec3 lower(0, 0.4999f, 0), upper(1, 0.5001f, 1);  // 1/100 of a voxel
    const DistanceField field = fieldOf({box(lower, upper, 0)}, 64);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const double truth = boxDistance(field.grid.center(v), lower, upper);
        EXPECT_NEAR(field.at(v), truth, 1e-7 * std::abs(truth) + 1e-15);
    });
}

// No closed form: signs by the sum of solid angles, on scenes of all kinds of meshes.
TEST(DistanceField, HasTheSignOfTheWindingNumber) {
    for (const char* name : {"boxes", "stairs", "courtyard"}) {
        const Scene scene = loadScene(name);
        const DistanceGrid grid = DistanceGrid::around(bounds(scene), 32);
        const DistanceField field = distanceField(scene.meshes, grid);
        std::vector<Mesh> solids;
        for (const Mesh& mesh : scene.meshes)
            if (closed(meshEdges(mesh))) solids.push_back(mesh);
        Random random(3);
        int within = 0;
        forEachVoxel(grid, [&](glm::ivec3 v) {
            if (field.at(v) >= 0.0f && random.unit() > 0.02f) return;
            const glm::vec3 p(grid.center(v));
            if (std::abs(field.at(v)) < 1e-5f * grid.cell) return;  // p is rounded to float32
            const bool inside = std::any_of(solids.begin(), solids.end(), [&](const Mesh& mesh) {
                return windingNumber(mesh, p) != 0;
            });
            EXPECT_EQ(field.at(v) < 0.0f, inside) << name;
            within += inside;
        });
        EXPECT_GT(within, 20) << name;
    }
}

TEST(DistanceField, ScalesExactlyByPowersOfTwo) {
    const Scene scene =
        sceneOf({sphere({0.3f, 1, -0.7f}, 0.9f, 9, 0), box({1, 0, 1}, {2, 3, 1.1f}, 0)});
    const DistanceField field = fieldOf(scene.meshes, 24);
    for (const int exponent : {-60, -7, 9, 60}) {
        const DistanceField other = fieldOf(scaled(scene, std::ldexp(1.0f, exponent)).meshes, 24);
        ASSERT_EQ(other.grid.size, field.grid.size);
        for (std::size_t i = 0; i < field.values.size(); ++i)
            ASSERT_EQ(other.values[i], std::ldexp(field.values[i], exponent)) << exponent;
    }
}

TEST(DistanceField, DoesNotCareHowFarTheOriginIs) {
    const glm::vec3 far(32768, -16384, 65536);  // corners of the box in 1/64: float32 holds them
    const glm::vec3 lower(-1, 0, 0.5f), upper(1.5f, 1, 1.25f);
    const std::vector<Mesh> meshes{box(lower + far, upper + far, 0)};
    const DistanceField field = fieldOf(meshes, 32);
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        const double truth =
            boxDistance(field.grid.center(v), glm::dvec3(lower + far), glm::dvec3(upper + far));
        EXPECT_NEAR(field.at(v), truth, 1e-7 * std::abs(truth) + 1e-11);  // 2^-53 of 65536
    });
}

TEST(DistanceField, IsTheSameOnAnyNumberOfCores) {
    const std::vector<Mesh> meshes{sphere({0, 0, 0}, 1, 12, 0), box({0.5f, 0, 0}, {2, 1, 1}, 0)};
    setThreadCount(1);
    const DistanceField one = fieldOf(meshes, 32);
    setThreadCount(5);
    const DistanceField five = fieldOf(meshes, 32);
    setThreadCount(0);
    EXPECT_EQ(one.values, five.values);
}

TEST(DistanceField, OfNothingIsAnError) {
    const DistanceGrid grid{{0, 0, 0}, 1.0f, {2, 2, 2}};
    EXPECT_THROW(distanceField({}, grid), Error);
    EXPECT_THROW(distanceField(std::vector{Mesh{}}, grid), Error);
}

TEST(DistanceField, StopsWhenCancelled) {
    const std::vector<Mesh> meshes{box({0, 0, 0}, {1, 1, 1}, 0)};
    Progress progress("test", 8, true);
    progress.cancelled = true;
    EXPECT_TRUE(distanceField(meshes, {{0, 0, 0}, 0.125f, {8, 8, 8}}, &progress).values.empty());
}

TEST(DistanceField, CountsItsSlices) {
    const std::vector<Mesh> meshes{box({0, 0, 0}, {1, 1, 1}, 0)};
    Progress progress("test", 16, true);
    distanceField(meshes, {{0, 0, 0}, 0.125f, {8, 8, 8}}, &progress);
    EXPECT_EQ(progress.fraction(), 0.5);
}

TEST(DistanceField, SamplesWithinHalfAVoxelsDiagonal) {
    const glm::vec3 lower(-1, 0, 0.5f), upper(1.5f, 1, 1.25f);
    const DistanceField field = fieldOf({box(lower, upper, 0)}, 32);
    const double bound = 0.5 * std::sqrt(3.0) * field.grid.cell;
    Random random(5);
    for (int i = 0; i < 10000; ++i) {
        const glm::vec3 part(random.unit(), random.unit(), random.unit());
        const glm::vec3 first(field.grid.center({0, 0, 0}));
        const glm::vec3 p = first + part * (glm::vec3(field.grid.size - 1) * field.grid.cell);
        EXPECT_NEAR(field.sample(p), boxDistance(p, lower, upper), bound);
    }
    forEachVoxel(field.grid, [&](glm::ivec3 v) {
        EXPECT_NEAR(field.sample(glm::vec3(field.grid.center(v))), field.at(v), 1e-6);
    });
}

// The bounds that distance_field.h states for a point outside the grid's box.
TEST(DistanceField, BoundsTheDistanceOutsideItsBox) {
    const std::vector<Mesh> meshes{sphere({0, 0, 0}, 1, 16, 0), box({2, 0, 0}, {3, 0.2f, 4}, 0)};
    const DistanceField field = fieldOf(meshes, 40);
    const double blur = 0.5 * std::sqrt(3.0) * field.grid.cell + 0.5 * field.grid.cell;
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 p =
            8.0f * glm::vec3(random.unit() - 0.5f, random.unit() - 0.5f, random.unit() - 0.5f);
        const glm::vec3 q = glm::clamp(p, field.grid.lower, field.grid.upper());
        if (p == q) continue;
        const double truth = bruteForce(meshes, p), away = glm::distance(p, q);
        const double value = field.sample(q);
        EXPECT_GE(truth, std::hypot(away, std::max(value - blur, 0.0)) - 1e-5);
        EXPECT_LE(truth, away + value + blur + 1e-5);
    }
}

// T7: along a ray that misses a sphere, the least of distance / way is sin(atan2(h, b) -
// asin(r/D)).
TEST(DistanceField, GivesTheSafeAngleOfASphere) {
    const glm::vec3 center(0, 0, 0);
    constexpr double kRadius = 1.0;
    const std::vector<Mesh> meshes{sphere(center, float(kRadius), 48, 0)};
    const DistanceField field =
        distanceField(meshes, DistanceGrid::around(bounds(meshes[0]), 64, 16));
    // The look-up errs by cell²/8 times the second derivatives, of which two are up to 1/radius
    // outside; the facets lie deeper by their sagitta. Both count times 1 / way.
    const double cell = field.grid.cell;
    const double error = 0.25 * cell * cell / kRadius + 1.0 - std::cos(0.70711 * 3.14159 / 48);
    for (const double height : {1.05, 1.2, 1.4}) {
        const double along = 1.0, distance = std::hypot(along, height);
        const double truth = std::sin(std::atan2(height, along) - std::asin(kRadius / distance));
        double least = 1.0, way = 1.0;
        for (double t = 0.05; t < 2.4; t += 0.001) {
            const double safe = double(field.sample(glm::vec3(t - along, height, 0))) / t;
            if (safe < least) least = safe, way = t;
        }
        EXPECT_NEAR(least, truth, error / way) << height;
    }
}

}  // namespace
}  // namespace penumbra
