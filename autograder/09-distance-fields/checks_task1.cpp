// Distances: of shapes, of places in the volume, beyond it, and of a whole scene on a slice.
#include <algorithm>
#include <cmath>

#include "field_checks.h"
#include "scene/mesh_edges.h"

namespace penumbra {
namespace {

TEST(Task1Distance, SpheresAndBoxesAreExactInsideAndOut) {
    Dice dice(11);
    Rows points, centers, sizes, truth;
    for (int i = 0; i < kRows; ++i) {
        const dvec3 center = dice.point(-2, 2), half = dice.point(0.2, 1);
        // Around all sides, edges and corners, and in the box: near a face, an edge, the middle.
        const dvec3 p = i % 2 ? center + half * dice.point(-1, 1) : center + dice.point(-3, 3);
        const RoundedBox sphere{center, dvec3(0), half.x}, box{center, half, 0};
        points.emplace_back(dvec4(p, 0));
        centers.emplace_back(dvec4(center, half.x));
        sizes.emplace_back(dvec4(half, 0));
        truth.emplace_back(dvec4(sphere.distance(p), box.distance(p), 0, 0));
    }
    const Rows distances = evaluate({.chunk = "distance.glsl",
                                     .expression = "vec4(sphereDistance(a.xyz, b.xyz, b.w), "
                                                   "boxDistance(a.xyz, b.xyz, c.xyz), 0.0, 0.0)",
                                     .inputs = {{"a", points}, {"b", centers}, {"c", sizes}}});
    EXPECT_ROWS_NEAR(
        distances, truth,
        {.absolute = 4e-6,
         .components = 2,
         .cause = "differences of coordinates up to 5, rounded to 5e-7, and some sums"});
}

TEST(Task1Distance, TheBoxesCornersAreTheTexturesCorners) {
    Dice dice(12);
    Rows points, lowers, uppers, truth;
    for (int i = 0; i < kRows; ++i) {
        const dvec3 lower = dice.point(-4, 4), size = dice.point(0.5, 6);
        const dvec3 uvw = i < 8 ? dvec3(i & 1, i >> 1 & 1, i >> 2) : dice.point(0, 1);
        points.emplace_back(dvec4(lower + uvw * size, 0));
        lowers.emplace_back(dvec4(lower, 0));
        uppers.emplace_back(dvec4(lower + size, 0));
        truth.emplace_back(dvec4(uvw, 0));
    }
    const Rows fieldCoordinate =
        evaluate({.chunk = "distance.glsl",
                  .expression = "vec4(fieldCoordinate(a.xyz, b.xyz, c.xyz), 0.0)",
                  .inputs = {{"a", points}, {"b", lowers}, {"c", uppers}}});
    EXPECT_ROWS_NEAR(
        fieldCoordinate, truth,
        {.absolute = 8e-6,
         .components = 3,
         .cause = "coordinates up to 10 are rounded to 1e-6, and sizes are 0.5 and more"});
}

TEST(Task1Distance, BeyondTheGridTheBoundIsTheLargestSoundOne) {
    Dice dice(13);
    Rows points, places, truth;
    for (int i = 0; i < kRows; ++i) {
        const dvec3 onBox = dice.point(-3, 3);
        // On a face, an edge, a corner's quarter of the space; or in the box, where signs are kept.
        const bool inside = i % 4 == 0;
        const double there = inside ? dice(-0.5, 0.5) : dice(0.01, 2);
        const dvec3 beyond =
            inside ? dvec3(0) : dice(0.01, 3) * dvec3(1, i % 4 > 1 ? 0.7 : 0, i % 4 > 2 ? 0.4 : 0);
        points.emplace_back(dvec4(vec3(onBox) + vec3(beyond), 0));
        places.emplace_back(dvec4(onBox, there));
        const double away = glm::length(dvec3(vec3(points.back()) - vec3(onBox)));
        truth.emplace_back(inside ? there : std::hypot(away, there));
    }
    const Rows distanceBeyond = evaluate({.chunk = "distance.glsl",
                                          .expression = "vec4(distanceBeyond(a.xyz, b.xyz, b.w))",
                                          .inputs = {{"a", points}, {"b", places}}});
    EXPECT_ROWS_NEAR(distanceBeyond, truth, {.cause = "float32 products and sums of a few terms"});
}

double squaredToSegment(dvec3 p, dvec3 a, dvec3 b) {
    const double along = glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
    const dvec3 offset = p - glm::mix(a, b, std::clamp(along, 0.0, 1.0));
    return glm::dot(offset, offset);
}

double squaredToTriangle(dvec3 p, dvec3 a, dvec3 b, dvec3 c) {
    const dvec3 n = glm::cross(b - a, c - a);
    const auto inner = [&](dvec3 from, dvec3 to) {
        return glm::dot(glm::cross(to - from, p - from), n) >= 0;
    };
    if (inner(a, b) && inner(b, c) && inner(c, a)) {
        const double height = glm::dot(p - a, n);
        return height * height / glm::dot(n, n);
    }
    return std::min(
        {squaredToSegment(p, a, b), squaredToSegment(p, b, c), squaredToSegment(p, c, a)});
}

// Distance to all triangles one by one, negative inside: no tree, no grid, no cache.
double distanceToAll(const std::vector<Mesh>& meshes, dvec3 p) {
    double nearest = INFINITY;
    bool inside = false;
    for (const Mesh& mesh : meshes) {
        for (const glm::uvec3 t : mesh.triangles)
            nearest =
                std::min(nearest, squaredToTriangle(p, mesh.positions[t.x], mesh.positions[t.y],
                                                    mesh.positions[t.z]));
        inside = inside || windingNumber(mesh, vec3(p)) != 0;
    }
    return (inside ? -1 : 1) * std::sqrt(nearest);
}

struct Grid {
    explicit Grid(const Image& field)
        : lower(field.at(0, 0, 0), field.at(0, 0, 1), field.at(0, 0, 2)),
          cell(field.at(0, 0, 3)),
          size(field.at(1, 0, 0), field.at(1, 0, 1), field.at(1, 0, 2)) {}
    dvec3 upper() const { return lower + cell * size; }
    dvec3 lower;
    double cell;
    dvec3 size;
};

// What the volume holds between voxel centres at height y: linear in all three directions.
class SliceTruth {
public:
    SliceTruth(const std::vector<Mesh>& meshes, const Grid& grid, double y)
        : grid_(grid), width_(int(grid.size.x)), depth_(int(grid.size.z)) {
        const double row = std::clamp((y - grid.lower.y) / grid.cell - 0.5, 0.0, grid.size.y - 1);
        const double below = std::floor(row), part = row - below;
        for (int k = 0; k < depth_; ++k)
            for (int i = 0; i < width_; ++i) {
                const dvec3 center = grid.lower + grid.cell * (dvec3(i, below, k) + 0.5);
                values_.push_back(std::lerp(distanceToAll(meshes, center),
                                            distanceToAll(meshes, center + dvec3(0, grid.cell, 0)),
                                            part));
            }
    }
    double at(double x, double z) const {
        const double u = std::clamp((x - grid_.lower.x) / grid_.cell - 0.5, 0.0, width_ - 1.0);
        const double w = std::clamp((z - grid_.lower.z) / grid_.cell - 0.5, 0.0, depth_ - 1.0);
        const int i = std::min(int(u), width_ - 2), k = std::min(int(w), depth_ - 2);
        const auto row = [&](int j) { return std::lerp(value(i, j), value(i + 1, j), u - i); };
        return std::lerp(row(k), row(k + 1), w - k);
    }

private:
    double value(int i, int k) const { return values_[std::size_t(k * width_ + i)]; }
    Grid grid_;
    int width_, depth_;
    std::vector<double> values_;
};

// Three closed meshes, few triangles, no symmetry between x and z.
Scene pieces() {
    Scene scene;
    scene.name = "pieces";
    scene.materials = {{.name = "grey"}};
    scene.meshes = {ground(8.0f, 1, 0), box({-1.6f, 0.4f, -0.8f}, {-0.2f, 1.5f, 0.9f}, 0),
                    sphere({1.1f, 0.9f, 0.3f}, 0.6f, 6, 0),
                    box({0.4f, 0.5f, 1.2f}, {0.7f, 1.3f, 1.4f}, 0)};
    scene.lights = {Light::lookingAt({1.0f, 7.0f, 0.5f}, {0.0f, 0.0f, 0.0f}, 1.0f)};
    scene.camera = {.eye = {0.0f, 3.0f, 6.0f},
                    .target = {0.0f, 0.5f, 0.0f},
                    .nearPlane = 1.0f,
                    .farPlane = 20.0f};
    return scene;
}

TEST(Task1Distance, ASliceShowsTheDistanceToEveryTriangle) {
    const Scene scene = pieces();
    const std::vector<Mesh> blockers(scene.meshes.begin() + 1, scene.meshes.end());
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = kSmall,
                                   .settings = {"grid=64", "slice=0.55"},
                                   .images = {{"distance", {256, 256}}, {"field", {2, 1}}}});
    const Grid grid(frame.at("field"));
    const dvec3 lower = grid.lower, size = grid.cell * grid.size, upper = grid.upper();
    const double y = lower.y + 0.55 * size.y;
    const SliceTruth slice(blockers, grid, y);
    Box box;
    for (const Mesh& mesh : blockers)
        for (const vec3 p : mesh.positions) box.include(p);
    const dvec3 middle = box.center(), half = 0.5 * dvec3(box.upper - box.lower);
    const double aside = std::max(std::abs(y - middle.y) - half.y, 0.0);
    Image truth(256, 256, 1);
    for (int j = 0; j < 256; ++j)
        for (int i = 0; i < 256; ++i) {
            const dvec2 part = 1.5 * dvec2(i + 0.5, j + 0.5) / 256.0 - 0.25;
            const dvec2 p = dvec2(lower.x, lower.z) + part * dvec2(size.x, size.z);
            const dvec2 q = glm::clamp(p, dvec2(lower.x, lower.z), dvec2(upper.x, upper.z));
            const double there = slice.at(q.x, q.y);
            // Outside the grid a point is as far as the blockers' own box, too.
            const dvec2 beside =
                glm::max(glm::abs(p - dvec2(middle.x, middle.z)) - dvec2(half.x, half.z), 0.0);
            truth.at(i, j) = float(p == q ? there
                                          : std::max(std::hypot(glm::length(p - q), there),
                                                     std::hypot(beside.x, beside.y, aside)));
        }
    EXPECT_IMAGE_NEAR(
        frame.at("distance"), truth,
        {.maximum = 1e-4,
         .cause = "the distance to each triangle at voxel centres, linear in between; "
                  "float32 coordinates of a look-up: 1e-5 of a voxel"});
}

}  // namespace
}  // namespace penumbra
