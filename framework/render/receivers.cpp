#include "render/receivers.h"

#include <array>
#include <span>

#include "core/error.h"

namespace penumbra {

namespace {

constexpr std::size_t kMostPlanes = 8;

struct Corner {
    glm::vec3 world;
    std::array<float, kMostPlanes> inside;  // signed distances, all >= 0 inside
};

Corner corner(glm::vec3 world, std::span<const glm::vec4> planes) {
    Corner c{world, {}};
    for (std::size_t i = 0; i < planes.size(); ++i)
        c.inside[i] = glm::dot(planes[i], glm::vec4(world, 1.0f));
    return c;
}

// Sutherland-Hodgman against one plane; distances are linear in space, so they interpolate.
void clipPlane(std::vector<Corner>& polygon, std::size_t plane, std::vector<Corner>& scratch) {
    scratch.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& a = polygon[i];
        const Corner& b = polygon[(i + 1) % polygon.size()];
        const float da = a.inside[plane], db = b.inside[plane];
        if (da >= 0) scratch.push_back(a);
        if ((da >= 0) != (db >= 0)) {
            const float t = da / (da - db);
            Corner c{glm::mix(a.world, b.world, t), {}};
            for (std::size_t k = 0; k < kMostPlanes; ++k)
                c.inside[k] = a.inside[k] + t * (b.inside[k] - a.inside[k]);
            scratch.push_back(c);
        }
    }
    polygon.swap(scratch);
}

enum class Side { inside, outside, both };

Side classify(std::span<const Corner> corners, std::size_t planes) {
    bool inside = true;
    for (std::size_t plane = 0; plane < planes; ++plane) {
        bool anyIn = false;
        for (const Corner& c : corners) {
            anyIn |= c.inside[plane] >= 0;
            inside &= c.inside[plane] >= 0;
        }
        if (!anyIn) return Side::outside;
    }
    return inside ? Side::inside : Side::both;
}

}  // namespace

std::vector<glm::vec3> pointsInside(const Scene& scene, std::span<const glm::vec4> planes) {
    EXPECTS(planes.size() <= kMostPlanes);
    std::vector<glm::vec3> points;
    std::vector<Corner> polygon, scratch;
    for (const Mesh& mesh : scene.meshes) {
        const Box box = bounds(mesh);
        if (box.empty()) continue;
        std::array<Corner, 8> corners;
        for (unsigned i = 0; i < 8; ++i)
            corners[i] =
                corner({i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                        i & 4 ? box.upper.z : box.lower.z},
                       planes);
        const Side side = classify(corners, planes.size());
        if (side == Side::outside) continue;
        if (side == Side::inside) {
            for (const Corner& c : corners) points.push_back(c.world);
            continue;
        }
        for (const glm::uvec3 t : mesh.triangles) {
            polygon.clear();
            for (int k = 0; k < 3; ++k) polygon.push_back(corner(mesh.positions[t[k]], planes));
            const Side triangle = classify(polygon, planes.size());
            if (triangle == Side::outside) continue;
            for (std::size_t plane = 0;
                 plane < planes.size() && triangle == Side::both && !polygon.empty(); ++plane)
                clipPlane(polygon, plane, scratch);
            for (const Corner& c : polygon) points.push_back(c.world);
        }
    }
    return points;
}

std::vector<glm::vec3> visiblePoints(const Scene& scene, const glm::mat4& clipFromWorld, Clip clip,
                                     glm::vec4 halfSpace) {
    const glm::mat4 rows = glm::transpose(clipFromWorld);
    const glm::vec4 x = rows[0], y = rows[1], z = rows[2], w = rows[3];
    // w > 0 takes the place of near and far when depth does not matter.
    const bool all = clip == Clip::all;
    const std::array planes{w + x,           w - x,           w + y,    w - y,
                            all ? w + z : w, all ? w - z : w, halfSpace};
    return pointsInside(scene, planes);
}

}  // namespace penumbra
