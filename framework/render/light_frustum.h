// What an area light's shadow map looks at: from the centre of the light along its axis, with sides
// along the light's edges, so that a square over the map is a square on the light.
//
//   LightFrustum frustum = areaLightFrustum(view);
//   mat4 clipFromWorld = frustum.clipFromView() * view.light.viewFromWorld();
//   vec2 scale = frustum.widthScaleUv(view.light.width);   // S of the formulas below
#pragma once

#include "render/frame.h"

namespace penumbra {

// Light view space: the light's centre is the origin, x right, y up, it looks along -z.
//
// With the depth d in [0,1] of this projection, 1/z is affine in d. Hence, for a blocker at depth b
// before a receiver at depth r, both parallel to the light:
//
//   S = widthScaleUv(light width) = width (1/near - 1/far) / (window's width as a tangent)
//   the light, seen from the receiver through the blocker's plane, covers S (r - b)     [uv]
//   whatever can block lies within S r                                                  [uv]
struct LightFrustum {
    float left = -1, right = 1, bottom = -1, top = 1;  // tangents x / -z and y / -z
    float nearPlane = 0.1f, farPlane = 100;            // distances along the axis [world]

    glm::mat4 clipFromView() const;
    glm::vec2 tangents() const { return {right - left, top - bottom}; }  // both > 0
    glm::vec2 widthScaleUv(float lightWidth) const;
};

// Holds every receiver that the camera sees before the light, and every blocker that can stand
// between one of them and any point of the square. As narrow as that allows, and no wider than 80
// degrees to a side: past it a planar map spends its texels on nothing.
LightFrustum areaLightFrustum(const View& view);

}  // namespace penumbra
