#include "scene/light.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace penumbra {

glm::mat4 Light::viewFromWorld() const {
    const glm::mat3 worldFromView(right, up, -forward());
    const glm::mat3 rotation = glm::transpose(worldFromView);
    glm::mat4 view(rotation);
    view[3] = glm::vec4(-(rotation * center), 1.0f);
    return view;
}

glm::vec4 Light::position() const {
    return directional ? glm::vec4(-forward(), 0.0f) : glm::vec4(center, 1.0f);
}

float Light::falloff(float distance) const {
    if (directional) return 1.0f;
    const float t = distance / range;
    const float rest = std::max(1.0f - t * t, 0.0f);
    return rest * rest;
}

Light Light::lookingAt(glm::vec3 center, glm::vec3 target, float width) {
    EXPECTS(glm::length(target - center) > 0.0f && width > 0.0f);
    const glm::vec3 forward = glm::normalize(target - center);
    const bool vertical = std::abs(forward.y) > 0.999f;
    const glm::vec3 reference = vertical ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    Light light;
    light.center = center;
    light.right = glm::normalize(glm::cross(forward, reference));
    light.up = glm::cross(light.right, forward);
    light.width = width;
    return light;
}

}  // namespace penumbra
