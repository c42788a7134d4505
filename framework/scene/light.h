// A square area light, or one so far away that its rays are parallel. Hard techniques use a
// square's centre as a point light.
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
#include <limits>

namespace penumbra {

// The light shines from its -Z face only: a receiver on or behind the light's plane has
// visibility 0, and so has one at or beyond its range. Elsewhere visibility is the fraction of the
// square's area that the receiver sees, without cosine; light points on or below the plane of the
// receiver's facet count as blocked. A directional light has neither plane nor width: every
// receiver sees all or nothing of it along -forward().
struct Light {
    glm::vec3 center{0.0f, 8.0f, 0.0f};
    glm::vec3 right{1.0f, 0.0f, 0.0f};  // unit, along one pair of edges
    glm::vec3 up{0.0f, 0.0f, -1.0f};    // unit, perpendicular to right
    float width = 1.5f;                 // > 0
    glm::vec3 color{1.0f};              // radiance scale, linear
    bool directional = false;           // shines along forward(); `center` is where it is drawn
    // World units. Light fades to nothing there (falloff); at infinity it ignores distance.
    float range = std::numeric_limits<float>::infinity();

    glm::vec3 forward() const { return glm::cross(up, right); }  // unit, -Z
    glm::mat4 viewFromWorld() const;

    // Homogeneous: (center, 1), or (-forward(), 0) for a directional light. The vector from p to
    // the light is position.xyz - position.w p, in one form for both.
    glm::vec4 position() const;

    // (1 - (distance / range)²)², 0 beyond; 1 for an infinite range and for directional lights.
    // Not 1/r²: a course's pictures need no exposure.
    float falloff(float distance) const;

    // The point of the square at (s, t) in [-1/2, 1/2]².
    glm::vec3 point(float s, float t) const { return center + width * (s * right + t * up); }

    bool operator==(const Light&) const = default;

    // A light at `center` that faces `target`; its right edge is horizontal (y = 0).
    static Light lookingAt(glm::vec3 center, glm::vec3 target, float width);
};

}  // namespace penumbra
