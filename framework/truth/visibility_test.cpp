#include "truth/visibility.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "truth/closed_form.h"
#include "truth/parallel.h"
#include "truth/test_scene.h"

namespace penumbra {

using namespace testing;

namespace {

// Receivers placed by hand on the floor y = 0.
Receivers floorRow(int count, const std::function<glm::vec3(int)>& position) {
    Receivers row{count, 1, {}, {}, {}};
    for (int i = 0; i < count; ++i) row.positions.push_back(position(i));
    row.facetNormals.assign(std::size_t(count), {0, 1, 0});
    row.hit.assign(std::size_t(count), 1);
    return row;
}

struct Difference {
    double mean = 0, rms = 0, maximum = 0;
};

Difference difference(const Image& image, const Receivers& receivers,
                      const std::function<double(std::size_t)>& truth) {
    Difference d;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (!receivers.hit[i]) continue;
        const double error = double(image.pixels[i]) - truth(i);
        d.mean += error / double(image.pixels.size());
        d.rms += error * error / double(image.pixels.size());
        d.maximum = std::max(d.maximum, std::abs(error));
    }
    d.rms = std::sqrt(d.rms);
    return d;
}

const std::array kBlocker{glm::vec3(-0.9f, 2.0f, 0.4f), glm::vec3(0.3f, 3.0f, 0.9f),
                          glm::vec3(0.8f, 2.5f, -0.2f), glm::vec3(-0.2f, 1.5f, -0.7f)};

// One convex blocker above the floor: T3 is the truth.
struct PolygonScene {
    RayTracer tracer{sceneOf({floorSquare(20), polygon(std::span(kBlocker).first(3))})};
    Light light = Light::lookingAt({2, 7, 1}, {0, 0, 0}, 1.5f);
    Receivers receivers = floorRow(2000, [](int i) {
        return glm::vec3(-3 + 5 * float(i % 50) / 50, 0, -2.5f + 4 * float(i / 50) / 40);
    });
    double truth(std::size_t i) const {
        const std::array triangle{glm::dvec3(kBlocker[0]), glm::dvec3(kBlocker[1]),
                                  glm::dvec3(kBlocker[2])};
        return polygonVisibility(receivers.positions[i], triangle, light);
    }
    double rmsAt(int samples) const {
        const Image image = areaVisibility(tracer, receivers, light, samples);
        return difference(image, receivers, [&](std::size_t i) { return truth(i); }).rms;
    }
};

// Solids over a floor, seen and lit from a side, for checks of the whole image.
Scene solids() {
    Scene scene = sceneOf(
        {floorSquare(12), globe({-1.2f, 1, 0}, 1, 12),
         parallelepiped({1.2f, 0.8f, 0.3f}, {1.2f, 0, 0.5f}, {0, 1.6f, 0}, {-0.4f, 0, 1.0f})});
    scene.lights[0] = Light::lookingAt({3, 6, 3}, {0, 0, 0}, 1.5f);
    return scene;
}

// A point light, one that ends at its range, and one without a place.
std::array<Light, 3> lightKinds() {
    std::array<Light, 3> lights;
    lights.fill(solids().lights[0]);
    lights[1].range = 7.5f;  // the floor's middle lies 7.3 away
    lights[2].directional = true;
    return lights;
}

}  // namespace

TEST(AreaVisibility, EqualsTheHalfPlanesClosedForm) {
    const RayTracer tracer(
        sceneOf({floorSquare(20), rectangle({-50, 2, 50}, {50, 0, 0}, {0, 0, -100})}));
    const Light light;  // at height 8, facing down
    const Receivers receivers =
        floorRow(401, [](int i) { return glm::vec3(-0.4f + 0.002f * float(i), 0, 0.3f); });
    const Image image = areaVisibility(tracer, receivers, light, 1024);
    const Difference d = difference(image, receivers, [&](std::size_t i) {
        return halfPlaneVisibility(receivers.positions[i].x, 2, 8, light.width);
    });
    // The edge runs along one column of 32 of the 32 x 32 strata, each seen with probability f:
    // σ = sqrt(32 f (1-f)) / 1024 <= 0.00276.
    EXPECT_LT(d.maximum, 4.5 * 0.00276);  // 401 pixels: 4.5 σ is passed in 0.3 % of seeds
    EXPECT_LT(d.rms, 0.00276);
    EXPECT_LT(std::abs(d.mean), 4 * 0.00276 / std::sqrt(401));  // no bias
}

TEST(AreaVisibility, EqualsThePolygonsClosedForm) {
    const PolygonScene scene;
    const Image image = areaVisibility(scene.tracer, scene.receivers, scene.light, 1024);
    const Difference d =
        difference(image, scene.receivers, [&](std::size_t i) { return scene.truth(i); });
    // At most 6 x 32 of the 1024 strata are cut by the triangle's edges: σ <= sqrt(192) / 2 / 1024
    // = 0.0068.
    EXPECT_LT(d.maximum, 4.5 * 0.0068);
    EXPECT_LT(d.rms, 0.0068);
    EXPECT_LT(std::abs(d.mean), 4 * 0.0068 / std::sqrt(2000));
}

TEST(AreaVisibility, ErrorFallsFasterThanIndependentSamplesWould) {
    const PolygonScene scene;
    const double at16 = scene.rmsAt(16), at256 = scene.rmsAt(256), at4096 = scene.rmsAt(4096);
    // Independent samples gain 4 for 16 times the rays, strata 8 (16^3/4); an rms over 2000 pixels,
    // of which 20 % are penumbra, is known to some 4 %.
    EXPECT_GT(at16 / at256, 5.0);
    EXPECT_GT(at256 / at4096, 5.0);
}

TEST(AreaVisibility, StandardErrorBoundsTheMeasuredError) {
    const PolygonScene scene;
    for (const int samples : {4, 37, 256}) {
        const Image image = areaVisibility(scene.tracer, scene.receivers, scene.light, samples);
        EXPECT_GT(standardError(image, samples), scene.rmsAt(samples)) << samples;
    }
    EXPECT_EQ(standardError(Image(2, 2, 1, 0.0f), 1), 0.5);
    EXPECT_EQ(standardError(Image(2, 2, 1, 1.0f), 9), 0.0);
    EXPECT_NEAR(standardError(Image(2, 2, 1, 0.5f), 26), 0.1, 1e-12);  // sqrt(1/4 / 25)
}

TEST(AreaVisibility, IsUnbiasedForAnyNumberOfSamples) {
    const PolygonScene scene;
    for (const int samples : {1, 2, 3, 7, 15, 17}) {
        const Image image = areaVisibility(scene.tracer, scene.receivers, scene.light, samples);
        const Difference d =
            difference(image, scene.receivers, [&](std::size_t i) { return scene.truth(i); });
        EXPECT_LT(std::abs(d.mean), 4 * d.rms / std::sqrt(2000)) << samples;  // 4 σ of the mean
    }
}

TEST(AreaVisibility, ConvexSolidsSeeWhatTheirFacetsHorizonLeaves) {
    // Alone in space, a convex solid's facet sees exactly the light above its plane: rays that leak
    // past an edge, or a facet that blocks its neighbour, would show here.
    for (const Mesh& solid :
         {globe({0, 0, 0}, 1.5f, 8), parallelepiped({0, 0, 0}, {2, 0, 1}, {0, 2, 0}, {-1, 0, 2})}) {
        Scene scene = sceneOf({solid});
        const RayTracer tracer(scene);
        const Light light =
            Light::lookingAt({-4.5f, 3, -1}, {0, 0, 0}, 3.0f);  // in the plane of the box's front
        const Receivers receivers = tracer.receivers(scene.camera, {96, 96});
        const Image image = areaVisibility(tracer, receivers, light, 256);
        int partly = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            if (!receivers.hit[i]) continue;
            const double v =
                horizonVisibility(receivers.positions[i], receivers.facetNormals[i], light);
            partly += v > 0 && v < 1;
            // The horizon cuts at most 2 x 16 of 256 strata: σ <= sqrt(32) / 2 / 256 = 0.011; none
            // at 0 and 1.
            EXPECT_NEAR(image.pixels[i], v, v > 0 && v < 1 ? 5 * 0.011 : 1e-6) << i;
        }
        EXPECT_GT(partly, 50);
    }
}

TEST(PointVisibility, ConvexSolidsAreLitExactlyWhereTheyFaceTheLight) {
    const Scene scene = sceneOf({globe({0, 0, 0}, 1.5f, 24)});
    const RayTracer tracer(scene);
    const Light light = Light::lookingAt({-4, 3, 2}, {0, 0, 0}, 3.0f);
    const Receivers receivers = tracer.receivers(scene.camera, {256, 256});
    const Image image = pointVisibility(tracer, receivers, light);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const bool faces =
            !receivers.hit[i] || glm::dot(glm::dvec3(receivers.facetNormals[i]),
                                          glm::dvec3(light.center - receivers.positions[i])) > 0;
        EXPECT_EQ(image.pixels[i], faces ? 1.0f : 0.0f) << i;
    }
}

TEST(PointVisibility, EqualsTheFloat64Predicate) {
    for (const Light& light : lightKinds()) {
        const Scene scene = solids();
        const RayTracer tracer(scene);
        const Receivers receivers = tracer.receivers(scene.camera, {128, 128});
        const Image image = pointVisibility(tracer, receivers, light);
        const glm::dvec4 position(light.position());
        std::vector<glm::dvec3> triangles;
        for (const Mesh& mesh : scene.meshes)
            for (const glm::uvec3 t : mesh.triangles)
                for (int k = 0; k < 3; ++k) triangles.push_back(mesh.positions[t[k]]);
        int blocked = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            if (!receivers.hit[i]) continue;
            const glm::dvec3 p = receivers.positions[i], n = receivers.facetNormals[i];
            const glm::dvec3 along = glm::dvec3(position) - position.w * p;
            if (glm::dot(n, along) <= 0) continue;
            double margin = 0;
            const bool free = segmentIsFree(p, position, triangles, &margin) &&
                              (light.directional || glm::length(along) < double(light.range));
            blocked += !free;
            // The start offset is 2e-6 of the scene's size of 17, magnified by grazing incidence.
            if (free != (image.pixels[i] == 1.0f)) {
                EXPECT_LT(margin, 2e-4) << i;
            }
        }
        EXPECT_GT(blocked, 300);
    }
}

TEST(Visibility, ADirectionalLightIsASquareVeryFarAway) {
    const Scene scene = solids();
    const RayTracer tracer(scene);
    const Receivers receivers = tracer.receivers(scene.camera, {128, 128});
    Light sun = scene.lights[0];
    sun.directional = true;
    Light far = scene.lights[0];
    far.center -= 1e6f * far.forward();
    const Image truth = pointVisibility(tracer, receivers, sun);
    EXPECT_EQ(areaVisibility(tracer, receivers, sun, 16).pixels, truth.pixels);
    const Image hard = pointVisibility(tracer, receivers, far);
    const Image soft = areaVisibility(tracer, receivers, far, 16);
    int different = 0, blocked = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        different += truth.pixels[i] != hard.pixels[i] || truth.pixels[i] != soft.pixels[i];
        blocked += truth.pixels[i] == 0.0f;
    }
    // Over the scene's 17 units the far light turns by 2e-5: its shadows of solids 2 high move by
    // 4e-5 units, 1/2000 of a pixel, on some 500 pixels of edges.
    EXPECT_LE(different, 2);
    EXPECT_GT(blocked, 500);
}

TEST(Visibility, ADirectionalLightHasNeitherPlaceNorRange) {
    const RayTracer tracer(sceneOf({floorSquare(1)}));
    const Receivers receivers =
        floorRow(3, [](int i) { return glm::vec3(100 * i, 7 + float(i), 0); });
    Light sun;  // its center, at height 8, is no place to be behind of
    sun.directional = true;
    sun.range = 1.0f;
    EXPECT_EQ(pointVisibility(tracer, receivers, sun).pixels, (std::vector<float>{1, 1, 1}));
    sun.up = -sun.up;  // it shines upwards: below the floor's horizon
    EXPECT_EQ(pointVisibility(tracer, receivers, sun).pixels, (std::vector<float>{0, 0, 0}));
    sun.up = sun.right;
    sun.right = {0, 1, 0};  // shines along z: in the horizon, where cosine and visibility are 0
    EXPECT_EQ(pointVisibility(tracer, receivers, sun).pixels, (std::vector<float>{0, 0, 0}));
}

TEST(Visibility, IsZeroFromTheRangeOn) {
    const RayTracer tracer(sceneOf({floorSquare(20)}));
    const Receivers receivers = floorRow(3, [](int i) { return glm::vec3(5 + i, 0, 0); });
    Light light;  // at height 8; distances 9.4, 10, 10.6
    light.range = 10.0f;
    EXPECT_EQ(pointVisibility(tracer, receivers, light).pixels, (std::vector<float>{1, 0, 0}));
    EXPECT_EQ(areaVisibility(tracer, receivers, light, 16).pixels, (std::vector<float>{1, 0, 0}));
}

TEST(Visibility, IsOneWhereTheCameraSeesNoSurface) {
    Scene scene = solids();
    scene.camera.target.y = 40;
    const RayTracer tracer(scene);
    const Receivers receivers = tracer.receivers(scene.camera, {5, 3});
    EXPECT_EQ(areaVisibility(tracer, receivers, scene.lights[0], 4).pixels,
              std::vector<float>(15, 1.0f));
    EXPECT_EQ(pointVisibility(tracer, receivers, scene.lights[0]).pixels,
              std::vector<float>(15, 1.0f));
}

TEST(Visibility, IsZeroOnAndBehindTheLightsPlane) {
    const RayTracer tracer(sceneOf({floorSquare(1)}));
    const Receivers receivers = floorRow(3, [](int i) { return glm::vec3(0, 7 + float(i), 0); });
    EXPECT_EQ(areaVisibility(tracer, receivers, Light{}, 16).pixels, (std::vector<float>{1, 0, 0}));
    EXPECT_EQ(pointVisibility(tracer, receivers, Light{}).pixels, (std::vector<float>{1, 0, 0}));
}

TEST(Visibility, LightThroughAMaskIsTheShareOfItsHoles) {
    // Columns of alpha 0 and 1 alternate; at cutoff 1/2 half of each pair is open.
    Mesh screen = rectangle({-8, 4, 8}, {16, 0, 0}, {0, 0, -16});
    for (glm::vec2& uv : screen.uvs)
        uv *= 40.0f;  // 2.5 pairs a unit, so 1.875 over the light's half shadow
    screen.material = 1;
    Scene scene = sceneOf({floorSquare(20), screen});
    scene.materials.push_back({.name = "slats", .texture = 0, .alphaCutoff = 0.5f});
    scene.textures.push_back({2, 1, {0, 0, 0, 0, 0, 0, 0, 255}});
    const RayTracer tracer(scene);
    const Receivers receivers = floorRow(
        256, [](int i) { return glm::vec3(0.8f * float(i) / 256.0f, 0, 0); });  // one period
    const Image image = areaVisibility(tracer, receivers, Light{}, 256);
    double mean = 0;
    for (const float v : image.pixels) mean += double(v) / 256;
    // Averaged over a period the truth is 1/2; each pixel's σ <= 1/2 / 16, the mean's a 16th of it.
    EXPECT_NEAR(mean, 0.5, 4 * 0.002);
}

TEST(Visibility, ScalesByPowersOfTwo) {
    Scene scene = solids();
    const auto image = [](const Scene& s) {
        const RayTracer tracer(s);
        return areaVisibility(tracer, tracer.receivers(s.camera, {64, 64}), s.lights[0], 16);
    };
    for (const Light& light : lightKinds()) {
        scene.lights[0] = light;
        const Image reference = image(scene);
        for (const int k : {-10, -1, 5, 10})
            EXPECT_EQ(image(scaled(scene, std::ldexp(1.0f, k))).pixels, reference.pixels) << k;
    }
}

TEST(Visibility, DoesNotDependOnTheNumberOfThreads) {
    const Scene scene = solids();
    const auto image = [&](int threads, std::uint32_t seed) {
        setThreadCount(threads);
        const RayTracer tracer(scene);
        const Receivers receivers = tracer.receivers(scene.camera, {64, 64});
        return areaVisibility(tracer, receivers, scene.lights[0], 13, nullptr, seed).pixels;
    };
    const auto one = image(1, 1), three = image(3, 1), sixteen = image(16, 1), other = image(1, 2);
    setThreadCount(0);
    EXPECT_EQ(one, three);
    EXPECT_EQ(one, sixteen);
    EXPECT_NE(one, other);
}

TEST(Visibility, StopsWhenCancelled) {
    const Scene scene = solids();
    const RayTracer tracer(scene);
    const Receivers receivers = tracer.receivers(scene.camera, {32, 32});
    Progress progress("cancelled", receivers.height);
    progress.cancelled = true;
    EXPECT_EQ(areaVisibility(tracer, receivers, scene.lights[0], 4, &progress).pixels,
              std::vector<float>(32 * 32, 1.0f));
    EXPECT_EQ(progress.fraction(), 0.0);
}

}  // namespace penumbra
