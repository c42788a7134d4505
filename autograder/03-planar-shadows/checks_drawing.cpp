// Planar shadows: marks in the stencil buffer, once and on the receiver alone.
#include <fmt/format.h>

#include "planar_checks.h"

namespace penumbra {
namespace {

// --- Task 3 ---

// The matrix of task 2 draws before the tasks after this one are done.
const Settings kMatrixAlone{"form=matrix", "clip=off"};

TEST(Task3Drawing, DarknessComesOnceUnderOverlappingCasters) {
    const Scene scene = overlappingCasters();
    const RayTruth rays(scene, {kSize, kSize});
    for (const float alpha : {0.25f, 0.5f, 1.0f}) {
        const Rendered frame =
            render({.scene = sceneFile(scene),
                    .size = {kSize, kSize},
                    .settings = {kMatrixAlone[0], kMatrixAlone[1], fmt::format("alpha={}", alpha)},
                    .images = {"visibility", "receiver"}});
        Image truth = rays.visibility;
        for (float& v : truth.pixels) v = v > 0 ? 1.0f : 1.0f - alpha;
        EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                          {.maximum = 1e-6,
                           .cause = fmt::format("one layer: visibility in shadow is 1 - {}, stored "
                                                "in float32",
                                                alpha)},
                          onReceiver(rays.interior, frame.at("receiver")));
    }
}

TEST(Task3Drawing, NoPixelFightsWithTheReceiver) {
    // The whole receiver but its rim is in shadow, seen at 4 degrees and from far away, where one
    // step of depth is largest.
    for (const int pose : {4, 5, 6}) {
        Scene scene = stage({0.3f, 9.0f, -0.4f});
        scene.meshes.push_back(
            polygonMesh({{-3, 0.5, -3}, {-3, 0.5, 3}, {3, 0.5, 3}, {3, 0.5, -3}}));
        scene.camera = {.eye = {5.0f, 4.0f, 60.0f},
                        .target = {0.0f, 0.0f, 0.0f},
                        .verticalFov = 0.12f,
                        .nearPlane = 0.1f,
                        .farPlane = 200.0f};
        scene = posed(scene, pose);
        const RayTruth rays(scene, {kSize, kSize});
        const Rendered frame = render({.scene = sceneFile(scene),
                                       .size = {kSize, kSize},
                                       .settings = kMatrixAlone,
                                       .images = {"visibility", "receiver"}});
        EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility,
                          {.maximum = 1e-6, .cause = "marks have no rounding"},
                          onReceiver(rays.interior, frame.at("receiver")));
    }
}

TEST(Task3Drawing, StopsAtTheReceiversEdge) {
    // The shadow of what stands on a table's edge would go on in the air.
    Scene scene = stage({-2.5f, 5.0f, 0.5f});
    scene.meshes[0] = ground(3.0f, 1, 0);
    scene.meshes[0].name = "receiver";
    scene.meshes.push_back(box({0.8f, 0.3f, -0.8f}, {1.3f, 1.8f, 0.9f}, 0));
    scene = posed(scene, 7);
    const RayTruth rays(scene, {kSize, kSize});
    const Rendered frame = render({.scene = sceneFile(scene),
                                   .size = {kSize, kSize},
                                   .settings = kMatrixAlone,
                                   .images = {"visibility", "receiver"}});
    Image mask = onReceiver(rays.interior, frame.at("receiver"));
    for (std::size_t i = 0; i < mask.pixels.size(); ++i)
        if (!rays.receivers.hit[i]) mask.pixels[i] = 1.0f;
    EXPECT_IMAGE_NEAR(frame.at("visibility"), rays.visibility,
                      {.maximum = 1e-6,
                       .cause = "background everywhere, and the receiver farther than a pixel from "
                                "a shadow's edge"},
                      mask);
}

TEST(Task3Drawing, NothingIsDrawnOverCasters) {
    for (const char* name : {"boxes@2", "fence@2"}) {
        const Scene scene = loadScene(name);
        const RayTruth rays(scene, {kSize, kSize});
        const Rendered frame = render({.scene = name,
                                       .size = {kSize, kSize},
                                       .settings = kMatrixAlone,
                                       .images = {"visibility", "receiver"}});
        // Casters bear attached shadow alone: dark where they face away.
        const vec3 light = scene.lights[0].center;
        Image truth(kSize, kSize, 1, 1.0f), mask(kSize, kSize, 1);
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            if (!rays.receivers.hit[i] || frame.at("receiver").pixels[i] != 0.0f) continue;
            const double cosine =
                glm::dot(dvec3(rays.receivers.facetNormals[i]),
                         glm::normalize(dvec3(light - rays.receivers.positions[i])));
            truth.pixels[i] = cosine > 0 ? 1.0f : 0.0f;
            // Within 3 degrees of its horizon, or where two facets share the pixel, derivatives of
            // the position decide.
            mask.pixels[i] = std::abs(cosine) > 0.05;
        }
        EXPECT_IMAGE_NEAR(frame.at("visibility"), truth,
                          {.outliers = 0.002,
                           .cause = std::string(name) + ": facets' edges, along which the pixel's "
                                                        "derivatives mix two facets"},
                          mask);
        EXPECT_VALUE(
            darkShare(frame, rays.visibility), GreaterOrEqual, 0.4,
            std::string(name) + ": on the receiver there is a shadow, if only a striped one");
    }
}

}  // namespace
}  // namespace penumbra
