#include "scene/blockers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "scene/mesh_edges.h"

namespace penumbra {

namespace {

struct Plane {
    glm::dvec3 point, normal;  // unit; 0 for a triangle without area: everything lies in its plane

    double height(glm::dvec3 p) const { return glm::dot(normal, p - point); }
};

Plane planeOf(const Mesh& mesh, glm::uvec3 t) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    return {a, length > 0.0 ? normal / length : glm::dvec3(0.0)};
}

// Heights over a plane of what a segment to the light may hold: least and most.
struct Heights {
    double least = 1e300, most = -1e300;

    void include(double height) { least = std::min(least, height), most = std::max(most, height); }
};

// The light's four corners; of a directional one, only the direction towards it counts.
void includeLight(const Plane& plane, const Light& light, Heights& heights) {
    if (light.directional) {
        // A segment from a receiver in the plane goes up, down or along.
        const double rise = -glm::dot(plane.normal, glm::dvec3(light.forward()));
        constexpr double kRounding = 1e-6;  // of a unit vector's coordinates
        if (std::abs(rise) > kRounding) heights.include(rise > 0.0 ? 1e300 : -1e300);
        return;
    }
    for (const float s : {-0.5f, 0.5f})
        for (const float t : {-0.5f, 0.5f}) heights.include(plane.height(light.point(s, t)));
}

// Points in groups, each with its box: a plane that leaves the box on one side need not ask for the
// points.
class Receivers {
public:
    Receivers(const Scene& scene, const Light& light) {
        for (const Mesh& mesh : scene.meshes) {
            const MeshEdges edges = meshEdges(mesh);
            const bool solid = facingTrianglesSuffice(mesh, edges, light.position());
            for (const glm::uvec3 t : mesh.triangles) {
                if (solid && averted(planeOf(mesh, t), light)) continue;
                for (const unsigned i : {t.x, t.y, t.z}) add(mesh.positions[i]);
            }
        }
    }

    // Whether some point lies more than `rounding` above the plane and some, or the light, more
    // than that below; `heights` holds the light's.
    bool onBothSides(const Plane& plane, Heights heights, double rounding) const {
        const auto both = [&] { return heights.least < -rounding && heights.most > rounding; };
        for (const Group& group : groups_) {
            if (both()) return true;
            const glm::dvec3 middle =
                0.5 * (glm::dvec3(group.box.lower) + glm::dvec3(group.box.upper));
            const glm::dvec3 half =
                0.5 * (glm::dvec3(group.box.upper) - glm::dvec3(group.box.lower));
            const double center = plane.height(middle),
                         reach = glm::dot(glm::abs(plane.normal), half);
            if (center - reach >= std::min(heights.least, -rounding) &&
                center + reach <= std::max(heights.most, rounding))
                continue;  // nothing new
            for (std::uint32_t i = group.first; i < group.first + group.count; ++i)
                heights.include(plane.height(points_[i]));
        }
        return both();
    }

private:
    static constexpr std::uint32_t kGroup = 64;
    struct Group {
        Box box;
        std::uint32_t first, count = 0;
    };

    static bool averted(const Plane& plane, const Light& light) {
        Heights heights;
        includeLight(plane, light, heights);
        return heights.most <= 0.0;
    }

    void add(glm::vec3 point) {
        if (groups_.empty() || groups_.back().count == kGroup)
            groups_.push_back({{}, std::uint32_t(points_.size())});
        groups_.back().box.include(point);
        ++groups_.back().count;
        points_.push_back(point);
    }

    std::vector<glm::vec3> points_;
    std::vector<Group> groups_;
};

bool canBlock(const Mesh& mesh, glm::uvec3 t, const Light& light, const Receivers& receivers,
              double rounding) {
    if (!light.directional) {
        double front = -1e300;  // how far it reaches in front of the light
        for (const unsigned i : {t.x, t.y, t.z})
            front =
                std::max(front, glm::dot(glm::dvec3(light.forward()),
                                         glm::dvec3(mesh.positions[i]) - glm::dvec3(light.center)));
        if (front <= rounding) return false;
    }
    const Plane plane = planeOf(mesh, t);
    Heights heights;
    includeLight(plane, light, heights);
    return receivers.onBothSides(plane, heights, rounding);
}

}  // namespace

std::vector<Mesh> possibleBlockers(const Scene& scene, const Light& light) {
    const Receivers receivers(scene, light);
    const Box box = bounds(scene);
    const glm::vec3 reach = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    const double rounding = std::ldexp(std::max({reach.x, reach.y, reach.z}), -20);
    std::vector<Mesh> blockers;
    for (const Mesh& mesh : scene.meshes)
        if (std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](glm::uvec3 t) {
                return canBlock(mesh, t, light, receivers, rounding);
            }))
            blockers.push_back(mesh);
    return blockers;
}

}  // namespace penumbra
