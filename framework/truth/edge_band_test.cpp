#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <random>

#include "truth/closed_form.h"
#include "truth/test_scene.h"
#include "truth/visibility.h"

namespace penumbra {

using namespace testing;

namespace {

constexpr int kMapSize = 256;

enum class Kind { point, directional, ranged };

struct BandScene {
    explicit BandScene(Kind kind = Kind::point) {
        if (kind == Kind::directional) {
            light.directional = true;
            clipFromWorld =
                glm::ortho(-9.0f, 9.0f, -9.0f, 9.0f, 0.5f, 20.0f) * light.viewFromWorld();
        }
        if (kind == Kind::ranged) light.range = 7.5f;  // the floor's middle lies 7.3 away
        visibility = pointVisibility(tracer, receivers, light);
    }

    Scene scene = sceneOf(
        {floorSquare(12), globe({-1.2f, 1, 0}, 1, 24),
         parallelepiped({1.2f, 0.8f, 0.3f}, {1.2f, 0, 0.5f}, {0, 1.6f, 0}, {-0.4f, 0, 1.0f})});
    Light light = Light::lookingAt({3, 6, 3}, {0, 0, 0}, 1.5f);
    RayTracer tracer{scene};
    Receivers receivers = tracer.receivers(scene.camera, {200, 200});
    glm::mat4 clipFromWorld = glm::perspective(1.6f, 1.0f, 1.0f, 20.0f) * light.viewFromWorld();
    Image visibility;

    Image band(float texels) const {
        return edgeBand(tracer, receivers, light, clipFromWorld, kMapSize, texels);
    }
    bool lit(std::size_t i, glm::dvec3 point) const {  // a point of receiver i's facet plane
        const glm::vec3 from = point, normal = receivers.facetNormals[i];
        const glm::vec4 position = light.position();
        const glm::vec3 along = glm::vec3(position) - position.w * from;
        if (glm::dot(normal, along) <= 0) return false;
        if (!light.directional && glm::length(along) >= light.range) return false;
        const glm::vec3 to = from + (light.directional ? 100.0f : 1.0f) * along;
        std::uint8_t blocked = 0;
        tracer.occluded({&from, 1}, {&normal, 1}, {&to, 1}, {&blocked, 1});
        return blocked == 0;
    }
    // The facet's point under the light ray that is moved by `shift` texels, by intersecting in
    // world space.
    glm::dvec3 moved(std::size_t i, glm::dvec2 shift) const {
        const glm::dmat4 clip(clipFromWorld), world = glm::inverse(clip);
        const glm::dvec3 p = receivers.positions[i], n = receivers.facetNormals[i];
        const glm::dvec4 at = clip * glm::dvec4(p, 1);
        const glm::dvec2 ndc = glm::dvec2(at) / at.w + shift * (2.0 / kMapSize);
        const glm::dvec4 far = world * glm::dvec4(ndc, 0.9, 1),
                         near = world * glm::dvec4(ndc, 0, 1);
        const glm::dvec3 l = glm::dvec3(near) / near.w, d = glm::dvec3(far) / far.w - l;
        return l + glm::dot(p - l, n) / glm::dot(d, n) * d;
    }
};

double share(const Image& band) {
    double sum = 0;
    for (const float v : band.pixels) sum += double(v);
    return sum / double(band.pixelCount());
}

}  // namespace

TEST(EdgeBand, CoversWhatAShiftByLessThanItsTexelsCanChange) {
    for (const Kind kind : {Kind::point, Kind::directional, Kind::ranged}) {
        const BandScene scene(kind);
        const Image band = scene.band(1.0f);
        std::mt19937 engine(11);
        const auto random = [&] { return double(engine()) / 4294967296.0 * 2 - 1; };
        int changed = 0, missed = 0;
        for (std::size_t i = 0; i < band.pixels.size(); ++i) {
            if (!scene.receivers.hit[i]) continue;
            for (int k = 0; k < 4; ++k) {
                const double x = random(), y = random();
                if (scene.lit(i, scene.moved(i, {x, y})) == (scene.visibility.pixels[i] == 1.0f))
                    continue;
                ++changed;
                missed += band.pixels[i] == 0.0f;
            }
        }
        EXPECT_GT(changed, 500);
        // Eight probes on half-texel rings miss a convex corner that enters the square between two
        // of them.
        EXPECT_LE(missed, changed / 200) << int(kind);
    }
}

TEST(EdgeBand, CoversWhatANearestTexelShadowMapGetsWrong) {
    const BandScene scene;
    const Image band = scene.band(1.0f);
    const Image depth = scene.tracer.depth(scene.clipFromWorld, {kMapSize, kMapSize});
    const glm::dmat4 clip(scene.clipFromWorld);
    int wrong = 0, missed = 0;
    for (std::size_t i = 0; i < band.pixels.size(); ++i) {
        const glm::dvec3 normal = scene.receivers.facetNormals[i], p = scene.receivers.positions[i];
        if (!scene.receivers.hit[i] || glm::dot(normal, glm::dvec3(scene.light.center) - p) <= 0)
            continue;
        const glm::dvec4 at = clip * glm::dvec4(p, 1);
        const glm::dvec3 ndc = glm::dvec3(at) / at.w;
        const int x = int((0.5 * ndc.x + 0.5) * kMapSize), y = int((0.5 - 0.5 * ndc.y) * kMapSize);
        ASSERT_TRUE(x >= 0 && y >= 0 && x < kMapSize && y < kMapSize);
        // Compared on the receiver's plane under the texel's centre, so that no bias is needed.
        const glm::dvec2 centre(2 * (x + 0.5) / kMapSize - 1, 1 - 2 * (y + 0.5) / kMapSize);
        const glm::dvec4 plane = glm::dvec4(normal, -glm::dot(normal, p)) * glm::inverse(clip);
        const double z = -(plane.x * centre.x + plane.y * centre.y + plane.w) / plane.z;
        const bool lit =
            0.5 * z + 0.5 <= double(depth.at(x, y)) + 1e-5;  // 0.01 units at distance 6
        if (lit == (scene.visibility.pixels[i] == 1.0f)) continue;
        ++wrong;
        missed += band.pixels[i] == 0.0f;
    }
    EXPECT_GT(wrong, 50);
    // The same corners, and facets of the globe that end within the texel: their neighbour lies
    // lower or higher than the plane by more than the 0.01 units allowed.
    EXPECT_LE(missed, wrong / 50);
}

TEST(EdgeBand, HoldsFewPixelsAndGrowsWithItsTexels) {
    const BandScene scene;
    const double half = share(scene.band(0.5f)), one = share(scene.band(1.0f)),
                 four = share(scene.band(4.0f));
    EXPECT_GT(half, 0.005);
    EXPECT_LT(half, one);
    EXPECT_LT(one, four);
    // Shadow and silhouette edges of two solids: some 6 lines of 80 pixels, 3 pixels wide, of 160².
    EXPECT_LT(one, 0.12);
}

TEST(EdgeBand, IsEmptyOnALonePlaneAndInTheBackground) {
    const Scene scene = sceneOf({floorSquare(60)});
    const RayTracer tracer(scene);
    Camera camera = scene.camera;
    const Receivers receivers = tracer.receivers(camera, {64, 64});
    const Light light = Light::lookingAt({3, 6, 3}, {0, 0, 0}, 1.5f);
    const glm::mat4 clip = glm::perspective(1.6f, 1.0f, 1.0f, 50.0f) * light.viewFromWorld();
    EXPECT_EQ(share(edgeBand(tracer, receivers, light, clip, kMapSize, 2.0f)), 0.0);
    camera.target = {0, 40, 0};
    const Receivers sky = tracer.receivers(camera, {8, 8});
    EXPECT_EQ(share(edgeBand(tracer, sky, light, clip, kMapSize, 2.0f)), 0.0);
}

TEST(EdgeBand, MarksSilhouettesInTheCamerasImage) {
    const BandScene scene;
    const Image band = scene.band(0.5f);
    for (int y = 0; y < band.height; ++y)
        for (int x = 1; x < band.width; ++x) {
            const std::size_t i = std::size_t(y * band.width + x);
            const bool jump =
                glm::distance(scene.receivers.positions[i], scene.receivers.positions[i - 1]) > 2;
            if (scene.receivers.hit[i] && scene.receivers.hit[i - 1] && jump &&
                scene.receivers.facetNormals[i] != scene.receivers.facetNormals[i - 1]) {
                EXPECT_EQ(band.pixels[i], 1.0f) << x << " " << y;
                EXPECT_EQ(band.pixels[i - 1], 1.0f) << x << " " << y;
            }
        }
}

}  // namespace penumbra
