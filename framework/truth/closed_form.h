// Exact visibility where a formula exists, in float64.
//
//   double v = halfPlaneVisibility(x, 2.0, 8.0, 1.0);     // T1
//   double v = polygonVisibility(receiver, {p0, p1, p2}, light);   // T3
//   double bias = planarDepthBias(texelSize, std::tan(angle), 1.0);   // T11
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/light.h"

namespace penumbra {

// Square light of width `lightWidth` at height `lightHeight`, half-plane blocker x < 0 at height
// `blockerHeight`, receiver on y = 0 at x, edges aligned: V = clamp(1/2 + x (H-h)/(h L), 0, 1).
double halfPlaneVisibility(double x, double blockerHeight, double lightHeight, double lightWidth);

// Convex polygon blocker (either winding) and the square light, each in any pose: V = 1 - A/L², A
// the area of the polygon's shadow from the receiver on the light's plane, clipped to the square.
// The part of the polygon that is not between receiver and light is cut off first. 0 on and behind
// the light's plane and from its range on. The receiver's own facet is not known here: see
// horizonVisibility. A directional light has no square: segmentIsFree is its truth.
double polygonVisibility(glm::dvec3 receiver, std::span<const glm::dvec3> convexBlocker,
                         const Light& light);

// The fraction of the square above the plane through the receiver with that normal: the visibility
// on any lone convex solid, and the most that any receiver can see. 0 on and behind the light's
// plane and from its range on. Not for directional lights.
double horizonVisibility(glm::dvec3 receiver, glm::dvec3 facetNormal, const Light& light);

// Point or directional light (homogeneous, as Light::position(); a direction is of unit length)
// against a triangle list (three corners each): true when the open segment receiver-light, or the
// ray towards the direction, meets no triangle. A triangle whose plane contains either end, within
// float32 rounding of the coordinates (2^-20), does not block: it is the receiver's own facet.
// `margin` receives how far [world] the nearest triangle is from changing the answer: the smaller
// of the crossing's distance to the triangle's edges and to the segment's ends. An answer whose
// margin is below the rounding of whoever disagrees with it decides nothing. Infinite without
// triangles.
bool segmentIsFree(glm::dvec3 receiver, glm::dvec4 light,
                   std::span<const glm::dvec3> triangleVertices, double* margin = nullptr);

// The depth bias along the light's axis [world] that a planar receiver needs against false shadow:
// (1/2 + r) h tan θ, orthographic texels of size h, filter radius r texels, θ between the plane's
// normal and the light's axis.
double planarDepthBias(double texelSize, double tangent, double radiusTexels);

}  // namespace penumbra
