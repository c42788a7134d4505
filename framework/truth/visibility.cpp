#include "truth/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "truth/parallel.h"
#include "truth/segment_queue.h"
#include "truth/strata.h"

namespace penumbra {

namespace {

// What one receiver's samples share. All that depends on a light point (s, t) is affine in s and t,
// so it is prepared once in float64 and costs a few multiplications a sample.
struct LightFromReceiver {
    glm::vec3 start;  // just above the facet
    glm::vec3 along;  // start to light point = along + s alongS + t alongT
    glm::vec3 alongS{0.0f}, alongT{0.0f};
    float height;  // of the light point above the facet's plane, likewise
    float heightS = 0.0f, heightT = 0.0f;
    float end;     // segments stop just before the light's plane
    bool reached;  // in front of the light's plane and within its range

    LightFromReceiver(const RayTracer& tracer, glm::vec3 position, glm::vec3 normal,
                      const Light& light) {
        if (light.directional) {
            start = position + tracer.startOffset(position) * normal;
            along = -light.forward();
            height = float(glm::dot(glm::dvec3(normal), glm::dvec3(along)));
            end = std::numeric_limits<float>::infinity();
            reached = true;
            return;
        }
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
        reached = toPlane > 0.0 && glm::length(toCenter) < double(light.range);
        end = reached ? 1.0f - std::min(0.5f, offset / float(toPlane)) : 1.0f;
    }

    bool allAboveHorizon() const {
        return height - 0.5f * (std::abs(heightS) + std::abs(heightT)) > 0.0f;
    }
};

// Random offsets within a cell: 16 bits for each coordinate.
struct Jitter {
    float s, t;

    explicit Jitter(std::uint32_t counter) {
        constexpr float kPerUnit = 1.0f / 65536.0f;
        const std::uint32_t bits = mixBits(counter);
        s = (float(int(bits >> 16)) + 0.5f) * kPerUnit;
        t = (float(int(bits & 0xffffu)) + 0.5f) * kPerUnit;
    }
};

// Sixteen samples of one receiver whose horizon cuts none of the light: loops of a fixed length, so
// that the compiler vectorises them. Returns how many see the light.
int seenOfSixteen(const RayTracer& tracer, const LightFromReceiver& to, const Strata& strata,
                  std::size_t first, std::uint32_t counter, SegmentPacket& packet) {
    constexpr int kLanes = SegmentPacket::kLanes;
    const float *cellS = &strata.s[first], *cellT = &strata.t[first];
    const float *width = &strata.width[first], *height = &strata.height[first];
    float s[kLanes], t[kLanes];
    for (int i = 0; i < kLanes; ++i) {
        const Jitter jitter(counter + std::uint32_t(i));
        s[i] = cellS[i] + width[i] * jitter.s;
        t[i] = cellT[i] + height[i] * jitter.t;
    }
    for (int i = 0; i < kLanes; ++i) packet.fromX[i] = to.start.x;
    for (int i = 0; i < kLanes; ++i) packet.fromY[i] = to.start.y;
    for (int i = 0; i < kLanes; ++i) packet.fromZ[i] = to.start.z;
    for (int i = 0; i < kLanes; ++i)
        packet.alongX[i] = to.along.x + s[i] * to.alongS.x + t[i] * to.alongT.x;
    for (int i = 0; i < kLanes; ++i)
        packet.alongY[i] = to.along.y + s[i] * to.alongS.y + t[i] * to.alongT.y;
    for (int i = 0; i < kLanes; ++i)
        packet.alongZ[i] = to.along.z + s[i] * to.alongS.z + t[i] * to.alongT.z;
    for (int i = 0; i < kLanes; ++i) packet.end[i] = to.end;
    packet.count = kLanes;
    return kLanes - std::popcount(tracer.blockedLanes(packet));
}

// Visibility of one row: one jittered point in each stratum.
// The horizon rule: points on or below the facet's plane count as blocked. Rays cannot decide that,
// since at a convex edge a ray that starts an offset above its facet slips past the edge (light
// leaks).
void traceRow(const RayTracer& tracer, const Receivers& receivers, const Light& light, int y,
              const Strata& strata, std::uint32_t seed, float* row) {
    constexpr std::size_t kLanes = SegmentPacket::kLanes;
    std::vector<int> seen(std::size_t(receivers.width), 0);
    SegmentPacket packet;
    // What does not fill a packet by itself is gathered over the borders of receivers.
    SegmentQueue queue(tracer, [&](std::size_t x, bool blocked) { seen[x] += blocked ? 0 : 1; });
    const std::size_t first = std::size_t(y) * std::size_t(receivers.width);
    for (std::size_t x = 0; x < seen.size(); ++x) {
        const std::size_t i = first + x;
        if (!receivers.hit[i]) continue;
        const LightFromReceiver to(tracer, receivers.positions[i], receivers.facetNormals[i],
                                   light);
        if (!to.reached) continue;
        const std::uint32_t counter = mixBits(std::uint32_t(i) ^ mixBits(seed));
        std::size_t k = 0;
        if (to.allAboveHorizon())
            for (; k + kLanes <= strata.size(); k += kLanes)
                seen[x] += seenOfSixteen(tracer, to, strata, k, counter + std::uint32_t(k), packet);
        for (; k < strata.size(); ++k) {
            const Jitter jitter(counter + std::uint32_t(k));
            const float s = strata.s[k] + strata.width[k] * jitter.s;
            const float t = strata.t[k] + strata.height[k] * jitter.t;
            if (to.height + s * to.heightS + t * to.heightT <= 0.0f) continue;
            queue.push(x, to.start, to.along + s * to.alongS + t * to.alongT, to.end);
        }
    }
    queue.flush();
    for (std::size_t x = 0; x < seen.size(); ++x)
        if (receivers.hit[first + x]) row[x] = float(double(seen[x]) / double(strata.size()));
}

Image trace(const RayTracer& tracer, const Receivers& receivers, const Light& light,
            const Strata& strata, Progress* progress, std::uint32_t seed) {
    Image visibility(receivers.width, receivers.height, 1, 1.0f);
    parallelFor(receivers.height, [&](int y) {
        if (progress && progress->cancelled) return;
        traceRow(tracer, receivers, light, y, strata, seed, &visibility.at(0, y));
        if (progress) progress->advance();
    });
    return visibility;
}

Strata centerAlone() { return {{0.0f}, {0.0f}, {0.0f}, {0.0f}}; }

}  // namespace

Image pointVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light) {
    return trace(tracer, receivers, light, centerAlone(), nullptr, 1);
}

Image areaVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light,
                     int samples, Progress* progress, std::uint32_t seed) {
    const Strata strata = light.directional ? centerAlone() : makeStrata(samples);
    return trace(tracer, receivers, light, strata, progress, seed);
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
