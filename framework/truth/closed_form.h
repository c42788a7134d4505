// Exact visibility where a formula exists, in float64.
//
//   double v = halfPlaneVisibility(x, 2.0, 8.0, 1.0);     // T1
//   double v = polygonVisibility(receiver, {p0, p1, p2}, light);   // T3
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/light.h"

namespace penumbra {

// Square light of width `lightWidth` at height `lightHeight`, half-plane blocker x < 0 at height
// `blockerHeight`, receiver on y = 0 at x, edges aligned: V = clamp(1/2 + x (H-h)/(h L), 0, 1).
double halfPlaneVisibility(double x, double blockerHeight, double lightHeight, double lightWidth);

// Convex polygon blocker and the square light: project from the receiver on the light's plane, clip
// to the square (Sutherland-Hodgman), V = 1 - A/L². The part of the polygon that is not between receiver
// and light is cut off first.
double polygonVisibility(glm::dvec3 receiver, std::span<const glm::dvec3> convexBlocker,
                         const Light& light);

// Point light against a triangle list: 1 when the open segment receiver-light meets no triangle.
// `margin` receives the smallest distance, in barycentric-free world units on the triangle's plane, of the
// crossing to a triangle edge: answers with a margin below rounding are not to be trusted.
bool segmentIsFree(glm::dvec3 receiver, glm::dvec3 light, std::span<const glm::dvec3> triangleVertices,
                   double* margin = nullptr);

}  // namespace penumbra
