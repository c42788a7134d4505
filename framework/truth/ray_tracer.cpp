#include "truth/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "truth/alpha_mask.h"
#include "truth/embree.h"
#include "truth/parallel.h"
#include "truth/segment_queue.h"

namespace penumbra {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// One mesh as Embree holds it; the arrays belong to the Embree geometry.
struct Facets {
    const glm::vec3* positions = nullptr;
    const glm::uvec3* triangles = nullptr;
    std::vector<glm::vec2> uvs;  // empty = all zero, as an absent vertex attribute
    std::optional<AlphaMask> mask;

    glm::dvec3 corner(unsigned triangle, int i) const { return positions[triangles[triangle][i]]; }
    glm::dvec2 uv(unsigned triangle, int i) const {
        return uvs.empty() ? glm::dvec2(0.0) : glm::dvec2(uvs[triangles[triangle][i]]);
    }
};

// Embree calls this for each candidate hit of a masked mesh, camera and shadow rays alike.
void rejectHoles(const RTCFilterFunctionNArguments* args) {
    const Facets& facets = *static_cast<const Facets*>(args->geometryUserPtr);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] != -1) continue;
        const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
        const double u = RTCHitN_u(args->hit, args->N, i), v = RTCHitN_v(args->hit, args->N, i);
        const glm::dvec2 uv = (1.0 - u - v) * facets.uv(triangle, 0) + u * facets.uv(triangle, 1) +
                              v * facets.uv(triangle, 2);
        if (facets.mask->isHole(uv)) args->valid[i] = 0;
    }
}

struct Hit {
    glm::dvec3 position;
    glm::dvec3 normal;  // unit, against the ray
};

}  // namespace

struct RayTracer::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::unique_ptr<Facets>> meshes;  // by Embree's geometry id
    float diagonal = 0.0f;

    State() = default;
    State(const State&) = delete;
    ~State() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
    void attach(const Scene& source, const Mesh& mesh);
    void throwOnError(const std::string& name) const;
    std::optional<Hit> firstHit(const Ray& ray, double nearest, double farthest) const;
};

void RayTracer::State::throwOnError(const std::string& name) const {
    if (const RTCError code = rtcGetDeviceError(device); code != RTC_ERROR_NONE)
        throw Error("cannot prepare the scene for ray tracing (Embree error " +
                        std::to_string(int(code)) + ")",
                    name, "free memory or use a smaller scene");
}

void RayTracer::State::attach(const Scene& source, const Mesh& mesh) {
    if (mesh.triangles.empty()) return;
    for (const glm::uvec3 t : mesh.triangles)
        EXPECTS(std::max({t.x, t.y, t.z}) < mesh.positions.size());
    EXPECTS(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), mesh.positions.size());
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              sizeof(glm::uvec3), mesh.triangles.size());
    throwOnError(source.name);
    auto facets = std::make_unique<Facets>();
    facets->positions = static_cast<const glm::vec3*>(positions);
    facets->triangles = static_cast<const glm::uvec3*>(triangles);
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(positions));
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<glm::uvec3*>(triangles));
    if (std::size_t(mesh.material) < source.materials.size()) {
        const Material& material = source.materials[std::size_t(mesh.material)];
        if (material.alphaCutoff > 0.0f && material.texture >= 0) {
            facets->uvs = mesh.uvs;
            facets->mask.emplace(source.textures.at(std::size_t(material.texture)),
                                 material.alphaCutoff);
            rtcSetGeometryUserData(geometry, facets.get());
            rtcSetGeometryIntersectFilterFunction(geometry, rejectHoles);
            rtcSetGeometryOccludedFilterFunction(geometry, rejectHoles);
        }
    }
    rtcCommitGeometry(geometry);
    const unsigned id = rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);  // the scene keeps it
    EXPECTS(id == meshes.size());
    meshes.push_back(std::move(facets));
}

RayTracer::RayTracer(const Scene& scene) : state_(std::make_unique<State>()) {
    state_->device = rtcNewDevice(nullptr);
    if (!state_->device)
        throw Error("cannot start Embree",
                    "Embree error " + std::to_string(rtcGetDeviceError(nullptr)),
                    "check the installed libembree");
    state_->scene = rtcNewScene(state_->device);
    rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(state_->scene, RTC_BUILD_QUALITY_MEDIUM);
    for (const Mesh& mesh : scene.meshes) state_->attach(scene, mesh);
    rtcCommitScene(state_->scene);
    state_->throwOnError(scene.name);
    state_->diagonal = bounds(scene).diagonal();
}

RayTracer::~RayTracer() = default;
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;

// Embree finds the triangle in float32; the point is then where the float64 ray meets the
// triangle's plane. A ray that grazes the plane makes that ill-conditioned: the hit's barycentrics
// decide there.
std::optional<Hit> RayTracer::State::firstHit(const Ray& ray, double nearest,
                                              double farthest) const {
    RTCRayHit found{};
    found.ray.org_x = float(ray.origin.x);
    found.ray.org_y = float(ray.origin.y);
    found.ray.org_z = float(ray.origin.z);
    found.ray.dir_x = float(ray.direction.x);
    found.ray.dir_y = float(ray.direction.y);
    found.ray.dir_z = float(ray.direction.z);
    found.ray.tnear = float(nearest);
    found.ray.tfar = float(farthest);
    found.ray.mask = ~0u;
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect1(scene, found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Facets& facets = *meshes[found.hit.geomID];
    const glm::dvec3 a = facets.corner(found.hit.primID, 0);
    const glm::dvec3 ab = facets.corner(found.hit.primID, 1) - a;
    const glm::dvec3 ac = facets.corner(found.hit.primID, 2) - a;
    const glm::dvec3 normal = glm::normalize(glm::cross(ab, ac));
    const double slope = glm::dot(normal, ray.direction);
    const glm::dvec3 byBarycentrics = a + double(found.hit.u) * ab + double(found.hit.v) * ac;
    const glm::dvec3 byPlane =
        ray.origin + glm::dot(a - ray.origin, normal) / slope * ray.direction;
    // Both are the same point but for float32 rounding of u and v: 2^-12 of the edges leaves it
    // room.
    const double room = std::ldexp(glm::length(ab) + glm::length(ac), -12);
    const bool trusted = glm::distance(byPlane, byBarycentrics) <= room;  // false for NaN
    return Hit{trusted ? byPlane : byBarycentrics, slope > 0.0 ? -normal : normal};
}

Receivers RayTracer::receivers(const Camera& camera, glm::ivec2 size) const {
    EXPECTS(size.x > 0 && size.y > 0);
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
    Receivers result{size.x, size.y, {}, {}, {}};
    result.positions.resize(count);
    result.facetNormals.resize(count);
    result.hit.resize(count);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    parallelFor(size.y, [&](int y) {
        for (int x = 0; x < size.x; ++x) {
            const Ray ray = camera.pixelRay(x, y, size);
            const double cosine =
                glm::dot(forward, ray.direction);  // the planes bound depth, not distance
            const auto hit =
                state_->firstHit(ray, camera.nearPlane / cosine, camera.farPlane / cosine);
            if (!hit) continue;
            const std::size_t i = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
            result.positions[i] = hit->position;
            result.facetNormals[i] = hit->normal;
            result.hit[i] = 1;
        }
    });
    return result;
}

float RayTracer::startOffset(glm::vec3 position) const {
    // Embree subtracts the start from the triangle's corners: the rounding is that of the position
    // itself and of distances up to the scene's diagonal; a dot and a cross product lose a few bits
    // more.
    constexpr float kUlps = 16.0f * std::numeric_limits<float>::epsilon();
    const glm::vec3 size = glm::abs(position);
    return kUlps * (std::max({size.x, size.y, size.z}) + state_->diagonal);
}

std::uint32_t RayTracer::blockedLanes(const SegmentPacket& packet) const {
    constexpr int kLanes = SegmentPacket::kLanes;
    RTCRay16 rays;
    alignas(64) int valid[kLanes];
    for (int i = 0; i < kLanes; ++i) {
        rays.org_x[i] = packet.fromX[i];
        rays.org_y[i] = packet.fromY[i];
        rays.org_z[i] = packet.fromZ[i];
        rays.dir_x[i] = packet.alongX[i];
        rays.dir_y[i] = packet.alongY[i];
        rays.dir_z[i] = packet.alongZ[i];
        rays.tnear[i] = 0.0f;
        rays.tfar[i] = packet.end[i];
        rays.time[i] = 0.0f;
        rays.mask[i] = ~0u;
        rays.id[i] = 0;
        rays.flags[i] = 0;
        valid[i] = i < packet.count ? -1 : 0;
    }
    embree::occluded16(valid, state_->scene, rays);
    std::uint32_t blocked = 0;
    for (int i = 0; i < kLanes; ++i) blocked |= std::uint32_t(rays.tfar[i] < 0.0f) << i;
    return packet.count == kLanes ? blocked : blocked & ((1u << packet.count) - 1u);
}

void RayTracer::occluded(std::span<const glm::vec3> from, std::span<const glm::vec3> fromNormals,
                         std::span<const glm::vec3> to, std::span<std::uint8_t> blocked) const {
    EXPECTS(from.size() == fromNormals.size() && from.size() == to.size());
    EXPECTS(from.size() == blocked.size());
    constexpr std::size_t kBlock = 4096;
    parallelFor(int((from.size() + kBlock - 1) / kBlock), [&](int block) {
        SegmentQueue queue(*this, [&](std::size_t i, bool isBlocked) { blocked[i] = isBlocked; });
        const std::size_t begin = std::size_t(block) * kBlock;
        for (std::size_t i = begin; i < std::min(begin + kBlock, from.size()); ++i)
            queue.push(i, from[i], fromNormals[i], to[i]);
        queue.flush();
    });
}

Image RayTracer::depth(const glm::mat4& clipFromWorld, glm::ivec2 size) const {
    EXPECTS(size.x > 0 && size.y > 0);
    const glm::dmat4 toClip(clipFromWorld);
    const glm::dmat4 toWorld = glm::inverse(toClip);
    Image result(size.x, size.y, 1, 1.0f);
    parallelFor(size.y, [&](int y) {
        for (int x = 0; x < size.x; ++x) {
            const double u = 2.0 * (x + 0.5) / size.x - 1.0, v = 1.0 - 2.0 * (y + 0.5) / size.y;
            const glm::dvec4 front = toWorld * glm::dvec4(u, v, -1.0, 1.0);
            const glm::dvec4 back = toWorld * glm::dvec4(u, v, 1.0, 1.0);
            const glm::dvec3 start = glm::dvec3(front) / front.w;
            // back.w = 0 where the far plane lies at infinity: back is then a direction.
            const bool infinite = std::abs(back.w) <= 1e-9 * std::abs(front.w);
            const glm::dvec3 along =
                infinite ? glm::dvec3(back) / front.w : glm::dvec3(back) / back.w - start;
            const double length = glm::length(along);
            const auto hit = state_->firstHit({start, along / length}, 0.0,
                                              infinite ? double(kInfinity) : length);
            if (!hit) continue;
            const glm::dvec4 clip = toClip * glm::dvec4(hit->position, 1.0);
            result.at(x, y) = float(std::clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0));
        }
    });
    return result;
}

}  // namespace penumbra
