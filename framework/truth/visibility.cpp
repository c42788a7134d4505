#include "truth/visibility.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "truth/parallel.h"
#include "truth/segment_queue.h"
#include "truth/strata.h"

namespace penumbra {

namespace {

// What one receiver's samples share. All that depends on a light point (s, t) is affine in s and t,
// so it is prepared once in float64 and costs a few multiplications a sample.
struct LightFromReceiver {
    glm::vec3 start;                  // just above the facet
    glm::vec3 along, alongS, alongT;  // start to light point = along + s alongS + t alongT
    float height, heightS, heightT;   // of the light point above the facet's plane, likewise
    float end;                        // segments stop just before the light's plane
    bool inFront;                     // of the light's plane

    LightFromReceiver(const RayTracer& tracer, glm::vec3 position, glm::vec3 normal,
                      const Light& light) {
        const glm::dvec3 right = double(light.width) * glm::dvec3(light.right);
        const glm::dvec3 up = double(light.width) * glm::dvec3(light.up);
        const glm::dvec3 n(normal), toCenter = glm::dvec3(light.center) - glm::dvec3(position);
        const float offset = tracer.startOffset(position);
        start = position + offset * normal;
        along = glm::dvec3(light.center) - glm::dvec3(start);
        alongS = right;
        alongT = up;
        height = float(glm::dot(n, toCenter));
        heightS = float(glm::dot(n, right));
        heightT = float(glm::dot(n, up));
        const double toPlane = -glm::dot(glm::dvec3(light.forward()), toCenter);
        inFront = toPlane > 0.0;
        end = inFront ? 1.0f - std::min(0.5f, offset / float(toPlane)) : 1.0f;
    }
};

// Visibility of one row: one jittered point in each stratum. Full packets of 16, over receivers'
// borders. The horizon rule: points on or below the facet's plane count as blocked. Rays cannot
// decide that, since at a convex edge a ray that starts an offset above its facet slips past the
// edge (light leaks).
void traceRow(const RayTracer& tracer, const Receivers& receivers, const Light& light, int y,
              std::span<const Stratum> strata, std::uint32_t seed, float* row) {
    std::vector<std::uint32_t> seen(std::size_t(receivers.width), 0u);
    SegmentQueue queue(tracer, [&](std::size_t x, bool blocked) { seen[x] += blocked ? 0u : 1u; });
    const std::size_t first = std::size_t(y) * std::size_t(receivers.width);
    constexpr float kPerUnit = 1.0f / 65536.0f;  // 16 random bits for each coordinate
    for (std::size_t x = 0; x < seen.size(); ++x) {
        const std::size_t i = first + x;
        if (!receivers.hit[i]) continue;
        const LightFromReceiver to(tracer, receivers.positions[i], receivers.facetNormals[i],
                                   light);
        if (!to.inFront) continue;
        std::uint32_t counter = pcgHash(std::uint32_t(i) ^ pcgHash(seed));
        for (const Stratum& cell : strata) {
            const std::uint32_t bits = pcgHash(counter++);
            const float s = cell.s + cell.width * (float(bits >> 16) + 0.5f) * kPerUnit;
            const float t = cell.t + cell.height * (float(bits & 0xffffu) + 0.5f) * kPerUnit;
            if (to.height + s * to.heightS + t * to.heightT <= 0.0f) continue;
            queue.push(x, to.start, to.along + s * to.alongS + t * to.alongT, to.end);
        }
    }
    queue.flush();
    for (std::size_t x = 0; x < seen.size(); ++x)
        if (receivers.hit[first + x]) row[x] = float(double(seen[x]) / double(strata.size()));
}

Image trace(const RayTracer& tracer, const Receivers& receivers, const Light& light,
            std::span<const Stratum> strata, Progress* progress, std::uint32_t seed) {
    Image visibility(receivers.width, receivers.height, 1, 1.0f);
    parallelFor(receivers.height, [&](int y) {
        if (progress && progress->cancelled) return;
        traceRow(tracer, receivers, light, y, strata, seed, &visibility.at(0, y));
        if (progress) progress->advance();
    });
    return visibility;
}

}  // namespace

Image pointVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light) {
    const Stratum center{0.0f, 0.0f, 0.0f, 0.0f};
    return trace(tracer, receivers, light, {&center, 1}, nullptr, 1);
}

Image areaVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light,
                     int samples, Progress* progress, std::uint32_t seed) {
    return trace(tracer, receivers, light, makeStrata(samples), progress, seed);
}

double standardError(const Image& visibility, int samples) {
    EXPECTS(visibility.channels == 1 && !visibility.empty() && samples >= 1);
    if (samples == 1) return 0.5;
    double variance = 0.0;
    for (const float v : visibility.pixels)
        variance += double(v) * (1.0 - double(v)) / double(samples - 1);
    return std::sqrt(variance / double(visibility.pixelCount()));
}

}  // namespace penumbra
