// A pinhole camera. Right-handed, y up, looks along -z in view space.
//
//   Camera camera{.eye = {0, 4, 8}, .target = {0, 0, 0}};
//   mat4 clipFromWorld = camera.clipFromView(aspect) * camera.viewFromWorld();
//   Ray ray = camera.pixelRay(x, y, size);   // through the centre of pixel (x, y), row 0 on top
#pragma once

#include <glm/glm.hpp>

namespace penumbra {

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;  // unit
};

struct Camera {
    glm::vec3 eye{0.0f, 4.0f, 8.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFov = 0.7f;  // radians, full angle
    float nearPlane = 0.1f;    // distances along the view axis, > 0
    float farPlane = 100.0f;

    glm::mat4 viewFromWorld() const;
    glm::mat4 clipFromView(float aspect) const;  // aspect = width / height; OpenGL clip space
    Ray pixelRay(int x, int y, glm::ivec2 size) const;

    bool operator==(const Camera&) const = default;
};

}  // namespace penumbra
