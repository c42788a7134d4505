#include "truth/volume_count.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/gallery.h"
#include "scene/mesh_edges.h"
#include "scene/orientation.h"
#include "truth/test_scene.h"
#include "truth/visibility.h"

namespace penumbra {

using namespace testing;

namespace {

int sideOf(const Mesh& mesh, glm::uvec3 t, glm::vec4 point) {
    return orientation(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], point);
}

// The volumes themselves, as surfaces: near caps, and sides from an edge's two ends away from the
// light. What a view ray enters minus what it leaves, in float64: Crow's count, independent of
// VolumesAround's.
class VolumeSurfaces {
public:
    VolumeSurfaces(const Scene& scene, const Light& light) : light_(light.position()) {
        for (const Mesh& mesh : scene.meshes) add(mesh);
    }

    int entered(glm::vec3 eye, glm::vec3 receiver) const {
        int sum = 0;
        for (const Cap& cap : caps_) sum += capEntered(cap, eye, receiver);
        for (const Side& side : sides_) sum += sideEntered(side, eye, receiver);
        return sum;
    }

private:
    struct Cap {
        glm::vec3 a, b, c;
        int towardsLight;
    };
    struct Side {
        glm::vec3 from, to;
        int sum;  // > 0: seen from the light, the volume lies left of from -> to
    };

    void add(const Mesh& mesh) {
        const MeshEdges edges = meshEdges(mesh);
        const bool facingOnly = facingTrianglesSuffice(mesh, edges, light_);
        std::vector<int> weights;
        for (const glm::uvec3 t : mesh.triangles) {
            const int side = sideOf(mesh, t, light_);
            weights.push_back(facingOnly ? std::max(side, 0) : side);
            if (weights.back() != 0)
                caps_.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z],
                                 weights.back()});
        }
        for (const MeshEdge& edge : edges.edges) {
            int sum = 0;
            for (const EdgeSide side : edges.sidesOf(edge))
                sum += side.direction * weights[side.triangle];
            if (sum != 0)
                sides_.push_back({mesh.positions[edge.from], mesh.positions[edge.to], sum});
        }
    }

    // A receiver on the cap, within rounding of its float32 position, is not behind it.
    static int capEntered(const Cap& cap, glm::vec3 eye, glm::vec3 receiver) {
        const glm::dvec3 a(cap.a), b(cap.b), c(cap.c), from(eye), to(receiver);
        const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
        const double before = glm::dot(n, from - a), after = glm::dot(n, to - a);
        if (std::abs(after) < 1e-5 || (before > 0.0) == (after > 0.0)) return 0;
        const glm::dvec3 x = from + before / (before - after) * (to - from);
        for (const auto& [p, q] : {std::pair(a, b), {b, c}, {c, a}})
            if (glm::dot(n, glm::cross(q - p, x - p)) < 0.0) return 0;
        return (before > 0.0) == (cap.towardsLight > 0) ? 1 : -1;  // from the lit side: enters
    }

    int sideEntered(const Side& side, glm::vec3 eye, glm::vec3 receiver) const {
        const glm::dvec3 p(side.from), q(side.to), from(eye), to(receiver);
        const glm::dvec3 light(light_);
        const double w = light_.w;
        const glm::dvec3 atP = light - w * p, atQ = light - w * q;  // towards the light
        const glm::dvec3 n = glm::cross(q - p, atP);
        const double before = glm::dot(n, from - p), after = glm::dot(n, to - p);
        if ((before > 0.0) == (after > 0.0)) return 0;
        const glm::dvec3 x = from + before / (before - after) * (to - from);
        // Within the plane: beyond the edge, seen from the light, and between the rays of its ends.
        const auto left = [&](glm::dvec3 start, glm::dvec3 along) {
            return glm::dot(n, glm::cross(along, x - start));
        };
        if (left(p, q - p) > 0.0) return 0;  // n x (q - p) points at the light's side of the edge
        if (left(p, atP) > 0.0 || left(q, atQ) < 0.0) return 0;
        return after > 0.0 ? -side.sum : side.sum;  // n points to the right of from -> to
    }

    glm::vec4 light_;
    std::vector<Cap> caps_;
    std::vector<Side> sides_;
};

struct Seen {
    Scene scene;
    Receivers receivers;
    VolumeCount truth;
};

Seen look(Scene scene, int size, CountedTriangles counted = CountedTriangles::asNeeded) {
    Receivers receivers = RayTracer(scene).receivers(scene.camera, {size, size});
    VolumeCount truth = volumeCount(scene, scene.camera, receivers, scene.lights[0], 0.5f, counted);
    return {std::move(scene), std::move(receivers), std::move(truth)};
}

double share(const Image& decidable, const Receivers& receivers) {
    double seen = 0.0, decided = 0.0;
    for (std::size_t i = 0; i < receivers.hit.size(); ++i)
        seen += receivers.hit[i], decided += double(decidable.pixels[i]);
    return decided / seen;
}

// T12: the volumes around the eye, plus what the view ray enters minus what it leaves.
TEST(VolumeCount, IsWhatTheViewRayEntersPlusTheVolumesAroundTheEye) {
    for (const char* name :
         {"boxes", "stairs", "eye_inside", "eye_inside@3", "near_cut", "near_cut@2", "nested@7",
          "lamp", "shut_lamp", "sun", "open_mesh", "mast", "board"}) {
        const Seen seen = look(loadScene(name), 64);
        const Light& light = seen.scene.lights[0];
        const glm::vec3 eye = seen.scene.camera.eye;
        const VolumeSurfaces surfaces(seen.scene, light);
        const int around = VolumesAround(seen.scene, light).at(eye);
        int wrong = 0;
        for (std::size_t i = 0; i < seen.receivers.hit.size(); ++i) {
            if (seen.truth.decidable.pixels[i] == 0.0f) continue;
            const int crossed = surfaces.entered(eye, seen.receivers.positions[i]);
            wrong += around + crossed != int(seen.truth.count.pixels[i]);
        }
        EXPECT_EQ(wrong, 0) << name;
        EXPECT_GT(share(seen.truth.decidable, seen.receivers), 0.6) << name;
    }
}

// T12 = T6: lit where no volume is, on receivers that the light can reach at all.
TEST(VolumeCount, IsZeroWhereTheRayToTheLightIsFree) {
    for (const char* name : {"boxes", "fence", "stairs", "foliage", "eye_inside", "near_cut",
                             "nested", "lamp", "shut_lamp", "sun", "open_mesh", "courtyard"})
        for (const auto counted : {CountedTriangles::asNeeded, CountedTriangles::all}) {
            const Seen seen = look(loadScene(name), 64, counted);
            Light light = seen.scene.lights[0];
            light.range = std::numeric_limits<float>::infinity();
            const Image visibility = pointVisibility(RayTracer(seen.scene), seen.receivers, light);
            int wrong = 0, compared = 0;
            for (std::size_t i = 0; i < seen.receivers.hit.size(); ++i) {
                if (seen.truth.decidable.pixels[i] == 0.0f) continue;
                const glm::vec4 at = light.position();
                const glm::vec3 p = seen.receivers.positions[i];
                const glm::vec3 toLight = glm::vec3(at) - at.w * p;
                if (glm::dot(toLight, seen.receivers.facetNormals[i]) <= 0.0f) continue;
                if (!light.directional && glm::dot(toLight, light.forward()) >= 0.0f) continue;
                ++compared;
                wrong += (seen.truth.count.pixels[i] == 0.0f) != (visibility.pixels[i] == 1.0f);
            }
            EXPECT_EQ(wrong, 0) << name << " of " << compared;
            EXPECT_GT(compared, 64 * 64 / 10) << name;
        }
}

TEST(VolumeCount, IsTheNumberOfSheetsBeneathThem) {
    for (const int sheets : {1, 7, 256, 300}) {
        const Seen seen = look(loadScene("nested@" + std::to_string(sheets)), 48);
        const auto& counts = seen.truth.count.pixels;
        EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), float(sheets));
        EXPECT_GT(std::count(counts.begin(), counts.end(), float(sheets)), 50) << sheets;
    }
}

TEST(VolumeCount, OfAllTrianglesCountsEntryAndExit) {
    const Scene scene = sceneOf({parallelepiped({0, 2, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})});
    Light light;
    light.center = {0.1f, 8, 0.2f};
    EXPECT_EQ(VolumesAround(scene, light).at({0, 0, 0}), 1);
    EXPECT_EQ(VolumesAround(scene, light, CountedTriangles::all).at({0, 0, 0}), 2);
    EXPECT_EQ(VolumesAround(scene, light).at({0, 2, 0}), 1) << "inside the box";
    EXPECT_EQ(VolumesAround(scene, light).at({3, 0, 0}), 0);
    EXPECT_EQ(VolumesAround(scene, light).at({0, 7, 0}), 0) << "between box and light";
    EXPECT_EQ(VolumesAround(scene, light).at({0, 2.5f, 0}), 0) << "on the facet: its own";
    EXPECT_EQ(VolumesAround(scene, light).at({0, 1.5f, 0}), 1) << "on the averted facet";
}

TEST(VolumeCount, SegmentThroughACommonEdgeOrCornerMeetsOneTriangle) {
    // Four triangles around the origin's height 1; the segments pass edges and the middle exactly.
    Mesh fan = polygon(std::array{glm::vec3(-1, 1, -1), glm::vec3(-1, 1, 1), glm::vec3(1, 1, 1),
                                  glm::vec3(1, 1, -1)});
    fan.positions.push_back({0, 1, 0});
    fan.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    Light light;
    light.center = {0, 2, 0};
    const VolumesAround volumes(sceneOf({fan}), light);
    for (const glm::vec3 p : {glm::vec3(0.5f, 0, 0.5f), glm::vec3(-0.5f, 0, 0.5f),
                              glm::vec3(0.25f, 0, -0.25f), glm::vec3(0, 0, 0)})
        EXPECT_EQ(volumes.at(p), 1) << p.x << ' ' << p.z;
}

TEST(VolumeCount, PowersOfTwoChangeNothing) {
    const Seen seen = look(loadScene("boxes"), 48);
    for (const float factor : {0x1p-20f, 0x1p20f}) {
        const Seen other = look(scaled(loadScene("boxes"), factor), 48);
        EXPECT_EQ(other.truth.count.pixels, seen.truth.count.pixels);
    }
}

TEST(EyeInsideScene, EyeIsInAVolume) {
    for (const char* name : {"eye_inside", "eye_inside@2", "eye_inside@3", "eye_inside@77"}) {
        const Scene scene = loadScene(name);
        EXPECT_GE(VolumesAround(scene, scene.lights[0]).at(scene.camera.eye), 1) << name;
        const Seen seen = look(scene, 48);
        const auto& counts = seen.truth.count.pixels;
        for (const float count : {0.0f, 1.0f})
            EXPECT_GT(std::count(counts.begin(), counts.end(), count), 200) << name;
    }
}

TEST(NearCutScene, VolumeCutsTheNearRectangleButNotTheEye) {
    for (const char* name : {"near_cut", "near_cut@2", "near_cut@3", "near_cut@77"}) {
        const Scene scene = loadScene(name);
        const Camera& camera = scene.camera;
        const VolumesAround volumes(scene, scene.lights[0]);
        EXPECT_EQ(volumes.at(camera.eye), 0) << name;
        const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
        int inside = 0, outside = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const Ray ray = camera.pixelRay(x, y, {16, 16});
                const double far = camera.nearPlane / glm::dot(ray.direction, forward);
                ++(volumes.at(ray.origin + far * ray.direction) > 0 ? inside : outside);
            }
        EXPECT_GT(inside, 50) << name;
        EXPECT_GT(outside, 50) << name;
    }
}

}  // namespace
}  // namespace penumbra
