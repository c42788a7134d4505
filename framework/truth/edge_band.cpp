#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "truth/parallel.h"
#include "truth/segment_queue.h"
#include "truth/visibility.h"

namespace penumbra {

namespace {

struct ShadowMapView {
    glm::dmat4 clipFromWorld;
    glm::dmat4 worldFromClip;
};

// Where the light ray that is moved by `shift` (NDC) in the map meets the receiver's facet plane.
// False when it does not: the ray grazes the plane, or meets it behind the light.
bool movedReceiver(const ShadowMapView& map, glm::dvec3 receiver, glm::dvec3 normal,
                   glm::dvec2 shift, glm::dvec3& moved) {
    const glm::dvec4 clip = map.clipFromWorld * glm::dvec4(receiver, 1.0);
    if (clip.w <= 0.0) return false;
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w + shift;
    // Homogeneous points of the moved ray: front + λ back covers it for λ >= 0, near to far plane.
    const glm::dvec4 front = map.worldFromClip * glm::dvec4(ndc, -1.0, 1.0);
    const glm::dvec4 back = map.worldFromClip * glm::dvec4(ndc, 1.0, 1.0);
    const glm::dvec4 plane(normal, -glm::dot(normal, receiver));
    const double a = glm::dot(plane, front), b = glm::dot(plane, back);
    const glm::dvec4 point = b * front - a * back;
    if (point.w == 0.0) return false;
    moved = glm::dvec3(point) / point.w;
    return (map.clipFromWorld * glm::dvec4(moved, 1.0)).w > 0.0;
}

// 8 directions on square rings at most half a texel apart, in texels: the square is a texel's
// shape.
std::vector<glm::dvec2> probeShifts(float texels) {
    std::vector<glm::dvec2> shifts;
    const int rings = std::max(1, int(std::ceil(2.0f * texels)));
    for (int ring = 1; ring <= rings; ++ring)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x != 0 || y != 0)
                    shifts.push_back(glm::dvec2(x, y) * (double(texels) * ring / rings));
    return shifts;
}

bool planesDiffer(const Receivers& receivers, std::size_t i, std::size_t j, double sine) {
    const glm::dvec3 apart =
        glm::dvec3(receivers.positions[j]) - glm::dvec3(receivers.positions[i]);
    const double room = sine * glm::length(apart);
    return std::abs(glm::dot(apart, glm::dvec3(receivers.facetNormals[i]))) > room ||
           std::abs(glm::dot(apart, glm::dvec3(receivers.facetNormals[j]))) > room;
}

// Whether the rasteriser, whose edges are snapped to 1/256 pixel, may see another surface than the
// ray. A neighbour more than 6 degrees off the plane is a crease or a step; the facets of a smooth
// mesh are flatter, and matter only where one is lit and the next is not.
bool surfaceEdge(const Receivers& receivers, const Image& visibility, int x, int y) {
    constexpr double kCrease = 0.1,
                     kOtherFacet = 1e-3;  // sines; the latter is above float rounding
    const auto index = [&](int px, int py) {
        return std::size_t(py) * std::size_t(receivers.width) + std::size_t(px);
    };
    const std::size_t i = index(x, y);
    for (int py = std::max(0, y - 1); py <= std::min(receivers.height - 1, y + 1); ++py)
        for (int px = std::max(0, x - 1); px <= std::min(receivers.width - 1, x + 1); ++px) {
            const std::size_t j = index(px, py);
            if (receivers.hit[j] != receivers.hit[i]) return true;
            if (!receivers.hit[i] || i == j) continue;
            if (planesDiffer(receivers, i, j, kCrease)) return true;
            if (visibility.pixels[i] != visibility.pixels[j] &&
                planesDiffer(receivers, i, j, kOtherFacet))
                return true;
        }
    return false;
}

// In front of the light's plane and within its range; a directional light has neither.
bool reaches(const Light& light, glm::dvec3 p) {
    const glm::dvec3 fromLight = p - glm::dvec3(light.center);
    return light.directional || (glm::dot(fromLight, glm::dvec3(light.forward())) > 0.0 &&
                                 glm::length(fromLight) < double(light.range));
}

}  // namespace

Image edgeBand(const RayTracer& tracer, const Receivers& receivers, const Light& light,
               const glm::mat4& lightClipFromWorld, int mapSize, float texels) {
    EXPECTS(mapSize > 0 && texels > 0.0f);
    const Image visibility = pointVisibility(tracer, receivers, light);
    const glm::dmat4 toClip(lightClipFromWorld);
    const ShadowMapView map{toClip, glm::inverse(toClip)};
    const std::vector<glm::dvec2> shifts = probeShifts(texels);
    const double ndcPerTexel = 2.0 / mapSize;
    const glm::vec4 toLight = light.position();
    const glm::dvec4 position(toLight);
    Image band(receivers.width, receivers.height, 1, 0.0f);
    parallelFor(receivers.height, [&](int y) {
        const float* own = visibility.pixels.data() + std::size_t(y) * std::size_t(receivers.width);
        float* row = &band.at(0, y);
        SegmentQueue queue(tracer, [&](std::size_t x, bool blocked) {
            if ((blocked ? 0.0f : 1.0f) != own[x]) row[x] = 1.0f;
        });
        for (int x = 0; x < receivers.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(receivers.width) + std::size_t(x);
            if (surfaceEdge(receivers, visibility, x, y)) row[x] = 1.0f;
            if (!receivers.hit[i] || row[x] != 0.0f) continue;
            const glm::dvec3 receiver(receivers.positions[i]), normal(receivers.facetNormals[i]);
            // All moved points share the facet's plane, so below the horizon they are unlit alike.
            if (glm::dot(normal, glm::dvec3(position) - position.w * receiver) <= 0.0) continue;
            for (const glm::dvec2 shift : shifts) {
                glm::dvec3 moved;
                if (!movedReceiver(map, receiver, normal, shift * ndcPerTexel, moved))
                    row[x] = 1.0f;
                else if (!reaches(light, moved))
                    row[x] = own[x] != 0.0f ? 1.0f : row[x];
                else
                    queue.push(std::size_t(x), moved, normal, toLight);
            }
        }
        queue.flush();
    });
    return band;
}

}  // namespace penumbra
