#include "truth/closed_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace penumbra {

namespace {

using Polygon = std::vector<glm::dvec3>;

// The part of a convex polygon where dot(plane, (p, 1)) >= 0 [Sutherland and Hodgman 1974].
Polygon clip(const Polygon& polygon, glm::dvec4 plane) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double a = glm::dot(plane, glm::dvec4(p, 1.0));
        const double b = glm::dot(plane, glm::dvec4(q, 1.0));
        if (a >= 0.0) kept.push_back(p);
        if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) kept.push_back(p + a / (a - b) * (q - p));
    }
    return kept;
}

double areaInXy(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return 0.5 * std::abs(twice);
}

// The light's frame: its square is |x|, |y| <= width / 2 in z = 0; it shines towards +z.
struct LightFrame {
    glm::dvec3 center, x, y, z;

    explicit LightFrame(const Light& light)
        : center(light.center), x(light.right), y(light.up), z(glm::cross(y, x)) {}
    glm::dvec3 fromWorld(glm::dvec3 p) const { return turned(p - center); }
    glm::dvec3 turned(glm::dvec3 v) const {
        return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
    }
};

}  // namespace

double halfPlaneVisibility(double x, double blockerHeight, double lightHeight, double lightWidth) {
    EXPECTS(0.0 < blockerHeight && blockerHeight < lightHeight && lightWidth > 0.0);
    const double slope = (lightHeight - blockerHeight) / (blockerHeight * lightWidth);
    return std::clamp(0.5 + x * slope, 0.0, 1.0);
}

double polygonVisibility(glm::dvec3 receiver, std::span<const glm::dvec3> convexBlocker,
                         const Light& light) {
    EXPECTS(!light.directional);
    const LightFrame frame(light);
    const glm::dvec3 p = frame.fromWorld(receiver);
    if (p.z <= 0.0 || glm::length(p) >= double(light.range)) return 0.0;
    Polygon polygon;
    for (const glm::dvec3 v : convexBlocker) polygon.push_back(frame.fromWorld(v));
    // Cutting to the pyramid receiver-square before projecting, not after, keeps every projected
    // point inside the square: nothing grows without bound as the polygon nears the receiver's
    // height.
    polygon = clip(polygon, {0, 0, 1, 0});
    polygon = clip(polygon, {0, 0, -1, p.z * (1.0 - 1e-12)});
    const double half = 0.5 * double(light.width);
    // Side |x| = half of the pyramid: at height z it lies at half + (p.x - half) z / p.z.
    for (const double side : {1.0, -1.0}) {
        polygon = clip(polygon, {-side, 0, (side * p.x - half) / p.z, half});
        polygon = clip(polygon, {0, -side, (side * p.y - half) / p.z, half});
    }
    for (glm::dvec3& v : polygon) v = p + (v - p) * (p.z / (p.z - v.z));
    return std::clamp(1.0 - areaInXy(polygon) / (4.0 * half * half), 0.0, 1.0);
}

double horizonVisibility(glm::dvec3 receiver, glm::dvec3 facetNormal, const Light& light) {
    EXPECTS(!light.directional);
    const LightFrame frame(light);
    const glm::dvec3 p = frame.fromWorld(receiver);
    if (p.z <= 0.0 || glm::length(p) >= double(light.range)) return 0.0;
    const glm::dvec3 n = frame.turned(facetNormal);
    const double half = 0.5 * double(light.width);
    const Polygon square{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    return std::min(1.0, areaInXy(clip(square, {n, -glm::dot(n, p)})) / (4.0 * half * half));
}

bool segmentIsFree(glm::dvec3 receiver, glm::dvec4 light,
                   std::span<const glm::dvec3> triangleVertices, double* margin) {
    EXPECTS(triangleVertices.size() % 3 == 0 && (light.w == 0.0 || light.w == 1.0));
    const glm::dvec3 end(light), along = end - light.w * receiver;
    const double length = glm::length(along);
    // Signed distance of the answer from its opposite, over the union of all triangles: > 0 is
    // blocked.
    double blockedBy = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < triangleVertices.size(); i += 3) {
        const glm::dvec3* corner = &triangleVertices[i];
        const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double area = glm::length(normal);  // twice the triangle's
        if (area == 0.0) continue;
        const glm::dvec3 n = normal / area;
        const double from = glm::dot(n, receiver - corner[0]);
        const double to = glm::dot(n, end - light.w * corner[0]);
        const glm::dvec3 size =
            glm::max(glm::abs(corner[0]), glm::max(glm::abs(receiver), light.w * glm::abs(end)));
        const double rounding = std::ldexp(std::max({size.x, size.y, size.z}), -20);
        const double roundingTo = light.w != 0.0 ? rounding : std::ldexp(1.0, -20);
        if (std::abs(from) <= rounding || std::abs(to) <= roundingTo) continue;
        const double slope = to - light.w * from;
        if (slope == 0.0) continue;  // parallel, and apart by more than rounding
        const double t = -from / slope;
        const glm::dvec3 crossing = receiver + t * along;
        double inside = (light.w != 0.0 ? std::min(t, 1.0 - t) : t) * length;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 a = corner[k], edge = corner[(k + 1) % 3] - a;
            const double distance = glm::dot(glm::cross(edge, crossing - a), n) / glm::length(edge);
            inside = std::min(inside, distance);
        }
        blockedBy = std::max(blockedBy, inside);
    }
    if (margin) *margin = std::abs(blockedBy);
    return blockedBy <= 0.0;
}

double planarDepthBias(double texelSize, double tangent, double radiusTexels) {
    EXPECTS(texelSize > 0.0 && tangent >= 0.0 && radiusTexels >= 0.0);
    return (0.5 + radiusTexels) * texelSize * tangent;
}

}  // namespace penumbra
