#include "app/viewer_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

namespace penumbra {

namespace {

constexpr float kPole = 0.03f;  // radians that stay between the line of sight and the vertical

glm::vec3 rotated(glm::vec3 v, float angle, glm::vec3 axis) {
    return glm::mat3(glm::rotate(glm::mat4(1.0f), angle, axis)) * v;
}

glm::vec3 rightOf(const Camera& camera) {
    return glm::normalize(glm::cross(camera.target - camera.eye, camera.up));
}

}  // namespace

void orbit(Camera& camera, glm::vec2 angles) {
    const glm::vec3 up = glm::normalize(camera.up);
    glm::vec3 offset = rotated(camera.eye - camera.target, -angles.x, up);
    const float fromPole = std::acos(std::clamp(glm::dot(glm::normalize(offset), up), -1.0f, 1.0f));
    const float wanted = std::clamp(fromPole - angles.y, kPole, 3.14159265f - kPole);
    const glm::vec3 right = glm::normalize(glm::cross(up, offset));
    camera.eye = camera.target + rotated(offset, wanted - fromPole, right);
}

void pan(Camera& camera, glm::vec2 drag) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye), right = rightOf(camera);
    const float height =
        2.0f * std::tan(0.5f * camera.verticalFov) * glm::length(camera.target - camera.eye);
    const glm::vec3 move = height * (-drag.x * right + drag.y * glm::cross(right, forward));
    camera.eye += move;
    camera.target += move;
}

void dolly(Camera& camera, float steps) {
    const glm::vec3 offset = camera.eye - camera.target;
    const float length = glm::length(offset);
    const float wanted = std::max(length * std::pow(0.9f, steps), 2.0f * camera.nearPlane);
    camera.eye = camera.target + offset * (wanted / length);
}

void keepInRange(Camera& camera, const Box& box, float least) {
    camera.farPlane = std::max(least, glm::length(camera.eye - box.center()) + box.diagonal());
}

void orbitLight(Light& light, const Camera& camera, glm::vec3 pivot, glm::vec2 angles) {
    const glm::vec3 up = glm::normalize(camera.up), right = rightOf(camera);
    const auto turn = [&](glm::vec3 v) {
        return rotated(rotated(v, angles.x, up), -angles.y, right);
    };
    light.center = pivot + turn(light.center - pivot);
    light.right = glm::normalize(turn(light.right));
    const glm::vec3 turnedUp = turn(light.up);
    light.up = glm::normalize(turnedUp - glm::dot(turnedUp, light.right) * light.right);
}

}  // namespace penumbra
