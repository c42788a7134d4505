#include "scene/camera.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace penumbra {

glm::mat4 Camera::viewFromWorld() const { return glm::lookAt(eye, target, up); }

glm::mat4 Camera::clipFromView(float aspect) const {
    return glm::perspective(verticalFov, aspect, nearPlane, farPlane);
}

Ray Camera::pixelRay(int x, int y, glm::ivec2 size) const {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(target) - glm::dvec3(eye));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(up)));
    const glm::dvec3 upward = glm::cross(right, forward);
    const double tangent = std::tan(0.5 * double(verticalFov));
    const double u = (2.0 * (x + 0.5) / size.x - 1.0) * tangent * size.x / size.y;
    const double v = (1.0 - 2.0 * (y + 0.5) / size.y) * tangent;
    return {eye, glm::normalize(forward + u * right + v * upward)};
}

}  // namespace penumbra
