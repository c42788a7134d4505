#include "truth/volume_count.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "scene/mesh_edges.h"
#include "scene/orientation.h"
#include "truth/parallel.h"

namespace penumbra {

namespace {

struct Caster {
    glm::vec3 corners[3];
    int towardsLight;   // the light's side: +1 or -1
    glm::dvec3 normal;  // unit
    double size;        // largest coordinate

    glm::vec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0f; }
};

double largest(glm::vec3 p) {
    return std::max({std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
}

void addCasters(const Mesh& mesh, glm::vec4 light, bool all, std::vector<Caster>& casters) {
    const bool facingOnly = !all && facingTrianglesSuffice(mesh, meshEdges(mesh), light);
    for (const glm::uvec3 t : mesh.triangles) {
        Caster caster{{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]}, 0, {}, 0};
        const auto& [a, b, c] = caster.corners;
        caster.towardsLight = orientation(a, b, c, light);
        if (caster.towardsLight == 0 || (facingOnly && caster.towardsLight < 0)) continue;
        caster.normal = glm::normalize(
            glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)));
        caster.size = std::max({largest(a), largest(b), largest(c)});
        casters.push_back(caster);
    }
}

// On which side of the plane (point, p, q) the light lies. An edge through the segment belongs to
// one of the two triangles that share it: the answer turns with the edge's direction.
int sideOfEdge(glm::vec3 point, glm::vec3 p, glm::vec3 q, glm::vec4 light) {
    if (const int side = orientation(point, p, q, light); side != 0) return side;
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z) ? 1 : -1;
}

bool planeHolds(glm::vec3 point, const Caster& caster) {
    constexpr double kRounding = 1.0 / (1 << 20);
    const double rounding = kRounding * std::max(caster.size, largest(point));
    const glm::dvec3 apart = glm::dvec3(point) - glm::dvec3(caster.corners[0]);
    return std::abs(glm::dot(caster.normal, apart)) <= rounding;
}

bool holds(glm::vec3 point, const Caster& caster) {
    if (!planeHolds(point, caster)) return false;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 from(caster.corners[k]), to(caster.corners[(k + 1) % 3]);
        const glm::dvec3 across = glm::cross(to - from, glm::dvec3(point) - from);
        if (glm::dot(caster.normal, across) < 0.0) return false;
    }
    return true;
}

bool crosses(glm::vec3 point, glm::vec4 light, const Caster& caster) {
    const auto& [a, b, c] = caster.corners;
    if (orientation(a, b, c, glm::vec4(point, 1.0f)) != -caster.towardsLight) return false;
    const int side = sideOfEdge(point, a, b, light);
    return sideOfEdge(point, b, c, light) == side && sideOfEdge(point, c, a, light) == side;
}

// A tree of boxes, leaves of at most four casters.
struct Node {
    glm::dvec3 lower, upper;             // a little larger than rounding can move the box
    std::uint32_t first = 0, count = 0;  // of casters; count 0: an inner node
    std::uint32_t second = 0;            // the inner node's second child; the first one follows it
};

class Tree {
public:
    explicit Tree(std::vector<Caster> casters) : casters_(std::move(casters)) {
        if (!casters_.empty()) build(0, std::uint32_t(casters_.size()));
    }

    // Calls visit(caster) for a superset of those that point + t along, 0 < t < end, meets.
    template <class Visit>
    void alongSegment(glm::dvec3 point, glm::dvec3 along, double end, Visit visit) const {
        std::array<std::uint32_t, 64> stack;  // depth: at most 32, as halves of 2^32 casters
        std::size_t waiting = 0;
        const glm::dvec3 perAlong = 1.0 / along;
        if (!nodes_.empty()) stack[waiting++] = 0;
        while (waiting > 0) {
            const std::uint32_t i = stack[--waiting];
            const Node& node = nodes_[i];
            if (!meets(node, point, along, perAlong, end)) continue;
            for (std::uint32_t k = 0; k < node.count; ++k) visit(casters_[node.first + k]);
            if (node.count == 0) stack[waiting++] = i + 1, stack[waiting++] = node.second;
        }
    }

private:
    static constexpr std::uint32_t kLeaf = 4;

    std::uint32_t build(std::uint32_t first, std::uint32_t last) {
        const auto index = std::uint32_t(nodes_.size());
        nodes_.emplace_back();
        Box box, middles;
        for (std::uint32_t i = first; i < last; ++i) {
            for (const glm::vec3 p : casters_[i].corners) box.include(p);
            middles.include(casters_[i].middle());
        }
        const double room = 1e-6 * std::max(largest(box.lower), largest(box.upper));
        nodes_[index].lower = glm::dvec3(box.lower) - room;
        nodes_[index].upper = glm::dvec3(box.upper) + room;
        if (last - first <= kLeaf) {
            nodes_[index].first = first, nodes_[index].count = last - first;
            return index;
        }
        const glm::vec3 side = middles.upper - middles.lower;
        const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
        const std::uint32_t half = first + (last - first) / 2;
        const auto begin = casters_.begin();
        std::nth_element(begin + first, begin + half, begin + last,
                         [axis](const Caster& a, const Caster& b) {
                             return a.middle()[axis] < b.middle()[axis];
                         });
        build(first, half);
        nodes_[index].second = build(half, last);
        return index;
    }

    // Slabs [Kay and Kajiya 1986].
    static bool meets(const Node& node, glm::dvec3 point, glm::dvec3 along, glm::dvec3 perAlong,
                      double end) {
        double enter = 0.0, leave = end;
        for (int k = 0; k < 3; ++k) {
            if (along[k] == 0.0) {
                if (point[k] < node.lower[k] || point[k] > node.upper[k]) return false;
                continue;
            }
            const double a = (node.lower[k] - point[k]) * perAlong[k];
            const double b = (node.upper[k] - point[k]) * perAlong[k];
            enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
        }
        return enter <= leave;
    }

    std::vector<Caster> casters_;
    std::vector<Node> nodes_;
};

std::vector<Caster> castersOf(const Scene& scene, const Light& light, CountedTriangles counted) {
    std::vector<Caster> casters;
    for (const Mesh& mesh : scene.meshes)
        addCasters(mesh, light.position(), counted == CountedTriangles::all, casters);
    return casters;
}

// Moves the receiver within its facet's plane to where the view ray through a place beside the
// pixel's centre meets it; NaN where that ray runs along the plane or away from it.
class Neighbourhood {
public:
    Neighbourhood(const Camera& camera, glm::ivec2 size, glm::ivec2 pixel)
        : eye_(camera.eye),
          ray_(camera.pixelRay(pixel.x, pixel.y, size).direction),
          right_(camera.pixelRay(pixel.x + 1, pixel.y, size).direction - ray_),
          down_(camera.pixelRay(pixel.x, pixel.y + 1, size).direction - ray_) {}

    glm::dvec3 moved(glm::dvec3 receiver, glm::dvec3 normal, glm::dvec2 byPixels) const {
        const glm::dvec3 direction = ray_ + byPixels.x * right_ + byPixels.y * down_;
        const double t = glm::dot(normal, receiver - eye_) / glm::dot(normal, direction);
        return t > 0.0 ? eye_ + t * direction
                       : glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    }

    double pixelWidth(glm::dvec3 receiver) const {
        return glm::distance(receiver, eye_) * glm::length(right_);
    }

private:
    glm::dvec3 eye_, ray_, right_, down_;
};

bool steady(const VolumesAround& volumes, const Neighbourhood& around, glm::dvec3 receiver,
            glm::dvec3 normal, double pixels) {
    const int count = volumes.at(receiver);
    const glm::dvec3 up = pixels * around.pixelWidth(receiver) * normal;
    if (volumes.besides(receiver, receiver + up) != count) return false;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            if (x == 0 && y == 0) continue;
            const glm::dvec3 p = around.moved(receiver, normal, pixels * glm::dvec2(x, y));
            if (std::isnan(p.x) || volumes.besides(receiver, p) != count) return false;
        }
    return true;
}

// The camera turned so that what it sees through a pixel's centre lies about that far beside it; in
// a picture's corners up to half as far again.
Camera turned(Camera camera, glm::ivec2 size, glm::dvec2 byPixels) {
    const glm::dvec3 ray = camera.pixelRay(size.x / 2, size.y / 2, size).direction;
    const glm::dvec3 right = camera.pixelRay(size.x / 2 + 1, size.y / 2, size).direction - ray;
    const glm::dvec3 down = camera.pixelRay(size.x / 2, size.y / 2 + 1, size).direction - ray;
    const double far = glm::distance(glm::dvec3(camera.eye), glm::dvec3(camera.target));
    camera.target += glm::vec3(far * (byPixels.x * right + byPixels.y * down));
    return camera;
}

// Clears pixels that see another plane, or nothing, from a 64th of a pixel beside: a rasteriser
// snaps edges to fractions of a pixel (1/256 is usual) and may see that one, or at a silhouette
// even the rim of what lies behind it.
void clearBesideAnother(const Scene& scene, const Camera& camera, const Receivers& receivers,
                        Image& decidable) {
    constexpr double kBeside = 1.0 / 64.0, kSine = 1e-3;  // the sine: above positions' rounding
    const glm::ivec2 size(receivers.width, receivers.height);
    const RayTracer tracer(scene);
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
        const Receivers other = tracer.receivers(turned(camera, size, kBeside * corner), size);
        parallelFor(size.y, [&](int y) {
            for (int x = 0; x < size.x; ++x) {
                const std::size_t i = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
                if (decidable.pixels[i] == 0.0f) continue;
                const glm::dvec3 apart(other.positions[i] - receivers.positions[i]);
                const double off = glm::dot(apart, glm::dvec3(receivers.facetNormals[i]));
                if (!other.hit[i] || std::abs(off) > kSine * glm::length(apart))
                    decidable.pixels[i] = 0.0f;
            }
        });
    }
}

}  // namespace

struct VolumesAround::State {
    State(const Scene& scene, const Light& from, CountedTriangles counted)
        : light(from.position()), tree(castersOf(scene, from, counted)) {}

    glm::vec4 light;
    Tree tree;
};

VolumesAround::VolumesAround(const Scene& scene, const Light& light, CountedTriangles counted)
    : state_(std::make_unique<State>(scene, light, counted)) {}
VolumesAround::~VolumesAround() = default;
VolumesAround::VolumesAround(VolumesAround&&) noexcept = default;

int VolumesAround::besides(glm::vec3 receiver, glm::vec3 place) const {
    const glm::vec4 light = state_->light;
    const glm::dvec3 along = towardsLight(place);
    const double end = light.w == 0.0f ? std::numeric_limits<double>::infinity() : 1.0;
    int count = 0;
    state_->tree.alongSegment(place, along, end, [&](const Caster& caster) {
        count += !planeHolds(receiver, caster) && crosses(place, light, caster);
    });
    return count;
}

glm::dvec3 VolumesAround::towardsLight(glm::dvec3 point) const {
    return glm::dvec3(state_->light) - double(state_->light.w) * point;
}

int VolumesAround::above(glm::vec3 receiver, glm::vec3 facetNormal) const {
    int count = at(receiver);
    if (glm::dot(towardsLight(receiver), glm::dvec3(facetNormal)) <= 0.0)
        state_->tree.alongSegment(receiver, glm::dvec3(0.0), 0.0,
                                  [&](const Caster& caster) { count += holds(receiver, caster); });
    return count;
}

VolumeCount volumeCount(const Scene& scene, const Camera& camera, const Receivers& receivers,
                        const Light& light, float pixels, CountedTriangles counted) {
    EXPECTS(pixels > 0.0f);
    const VolumesAround volumes(scene, light, counted);
    const glm::ivec2 size(receivers.width, receivers.height);
    VolumeCount result{Image(size.x, size.y, 1), Image(size.x, size.y, 1)};
    parallelFor(size.y, [&](int y) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
            if (!receivers.hit[i]) continue;
            const glm::dvec3 p(receivers.positions[i]), normal(receivers.facetNormals[i]);
            result.count.pixels[i] = float(volumes.above(p, normal));
            const Neighbourhood around(camera, size, {x, y});
            result.decidable.pixels[i] = steady(volumes, around, p, normal, pixels) ? 1.0f : 0.0f;
        }
    });
    clearBesideAnother(scene, camera, receivers, result.decidable);
    return result;
}

}  // namespace penumbra
