#include "render/receivers.h"

#include <array>
#include <span>

namespace penumbra {

namespace {

constexpr std::size_t kPlanes = 7;  // the clip volume's six and the half space

struct Region {
    glm::mat4 clipFromWorld;
    Clip clip;
    glm::vec4 halfSpace;
};

struct Corner {
    glm::vec3 world;
    std::array<float, kPlanes> inside;  // signed distances, all >= 0 inside
};

// w > 0 takes the place of near and far when depth does not matter.
Corner corner(glm::vec3 world, const Region& region) {
    const glm::vec4 p = region.clipFromWorld * glm::vec4(world, 1.0f);
    const bool all = region.clip == Clip::all;
    return {world,
            {p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, all ? p.w + p.z : p.w,
             all ? p.w - p.z : p.w, glm::dot(region.halfSpace, glm::vec4(world, 1.0f))}};
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
            for (std::size_t k = 0; k < kPlanes; ++k)
                c.inside[k] = a.inside[k] + t * (b.inside[k] - a.inside[k]);
            scratch.push_back(c);
        }
    }
    polygon.swap(scratch);
}

enum class Side { inside, outside, both };

Side classify(std::span<const Corner> corners) {
    bool inside = true;
    for (std::size_t plane = 0; plane < kPlanes; ++plane) {
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

std::vector<glm::vec3> visiblePoints(const Scene& scene, const glm::mat4& clipFromWorld, Clip clip,
                                     glm::vec4 halfSpace) {
    const Region region{clipFromWorld, clip, halfSpace};
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
                       region);
        const Side side = classify(corners);
        if (side == Side::outside) continue;
        if (side == Side::inside) {
            for (const Corner& c : corners) points.push_back(c.world);
            continue;
        }
        for (const glm::uvec3 t : mesh.triangles) {
            polygon.clear();
            for (int k = 0; k < 3; ++k) polygon.push_back(corner(mesh.positions[t[k]], region));
            const Side triangle = classify(polygon);
            if (triangle == Side::outside) continue;
            for (std::size_t plane = 0;
                 plane < kPlanes && triangle == Side::both && !polygon.empty(); ++plane)
                clipPlane(polygon, plane, scratch);
            for (const Corner& c : polygon) points.push_back(c.world);
        }
    }
    return points;
}

}  // namespace penumbra
