// A square area light. Hard techniques use its centre as a point light.
//
//            up (+Y)
//         +----^----+
//         |    |    |   width (full, world units)
//         |    o--->|   right (+X)          faces along -Z = forward(), out of this page's back
//         +---------+
//
//   Light light = Light::lookingAt({3, 8, 2}, {0, 0, 0}, 1.5f);
//   mat4 lightViewFromWorld = light.viewFromWorld();   // the light looks along -z
#pragma once

#include <glm/glm.hpp>

namespace penumbra {

// The light shines from its -Z face only: a receiver on or behind the light's plane has
// visibility 0. Elsewhere visibility is the fraction of the square's area that the receiver sees,
// without cosine; light points on or below the plane of the receiver's facet count as blocked.
struct Light {
    glm::vec3 center{0.0f, 8.0f, 0.0f};
    glm::vec3 right{1.0f, 0.0f, 0.0f};  // unit, along one pair of edges
    glm::vec3 up{0.0f, 0.0f, -1.0f};    // unit, perpendicular to right
    float width = 1.5f;                 // > 0
    glm::vec3 color{1.0f};              // radiance scale, linear; shading ignores distance

    glm::vec3 forward() const { return glm::cross(up, right); }  // unit, -Z
    glm::mat4 viewFromWorld() const;

    // The point of the square at (s, t) in [-1/2, 1/2]².
    glm::vec3 point(float s, float t) const { return center + width * (s * right + t * up); }

    // A light at `center` that faces `target`; its right edge is horizontal (y = 0).
    static Light lookingAt(glm::vec3 center, glm::vec3 target, float width);
};

}  // namespace penumbra
