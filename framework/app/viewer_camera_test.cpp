#include "app/viewer_camera.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

constexpr float kRounding = 1e-4f;  // some float32 rotations of lengths about 10

TEST(Orbit, KeepsTargetAndDistance) {
    Camera camera;
    const float distance = glm::length(camera.eye - camera.target);
    for (int i = 0; i < 50; ++i) orbit(camera, {0.3f, 0.1f});
    EXPECT_EQ(camera.target, Camera().target);
    EXPECT_NEAR(glm::length(camera.eye - camera.target), distance, kRounding);
}

TEST(Orbit, StopsBeforeThePole) {
    Camera camera;
    for (int i = 0; i < 50; ++i) orbit(camera, {0.0f, 0.5f});
    EXPECT_GT(camera.eye.y, 0.99f * glm::length(camera.eye));
    const glm::vec3 right = glm::cross(camera.target - camera.eye, camera.up);
    EXPECT_GT(glm::length(right), 0.01f);
}

TEST(Orbit, UpwardRaisesTheEye) {
    Camera camera;
    orbit(camera, {0.0f, 0.1f});
    EXPECT_GT(camera.eye.y, Camera().eye.y);
}

TEST(Pan, KeepsTheLineOfSight) {
    Camera camera;
    pan(camera, {0.2f, -0.3f});
    const glm::vec3 before = Camera().target - Camera().eye, after = camera.target - camera.eye;
    EXPECT_NEAR(glm::length(after - before), 0.0f, kRounding);
    EXPECT_GT(glm::length(camera.target), 0.1f);
}

TEST(Dolly, NeverReachesTheTarget) {
    Camera camera;
    dolly(camera, 1000);
    EXPECT_NEAR(glm::length(camera.eye - camera.target), 2 * camera.nearPlane, kRounding);
}

TEST(OrbitLight, KeepsASquareThatFacesThePivot) {
    const glm::vec3 pivot(1, 0, 2);
    Light light = Light::lookingAt({3, 8, 2}, pivot, 1.5f);
    const float distance = glm::length(light.center - pivot);
    for (int i = 0; i < 50; ++i) orbitLight(light, Camera(), pivot, {0.2f, 0.05f});
    EXPECT_NEAR(glm::length(light.center - pivot), distance, kRounding);
    EXPECT_NEAR(glm::dot(light.right, light.up), 0.0f, kRounding);
    EXPECT_NEAR(glm::length(light.forward()), 1.0f, kRounding);
    EXPECT_NEAR(glm::dot(light.forward(), glm::normalize(pivot - light.center)), 1.0f, kRounding);
}

}  // namespace
}  // namespace penumbra
