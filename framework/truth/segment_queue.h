// Gathers segments into full packets, whoever they belong to, and reports each answer with its tag.
//
//   SegmentQueue queue(tracer, [&](std::size_t tag, bool blocked) { … });
//   queue.push(pixel, receiver, facetNormal, lightPoint);
//   queue.flush();   // at the end: traces what is left
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>

#include "truth/ray_tracer.h"

namespace penumbra {

template <class Report>
class SegmentQueue {
public:
    SegmentQueue(const RayTracer& tracer, Report report) : tracer_(tracer), report_(report) {}

    // From just above the facet to just before `to`, so that neither end's own surface blocks.
    void push(std::size_t tag, glm::vec3 receiver, glm::vec3 facetNormal, glm::vec3 to) {
        const float offset = tracer_.startOffset(receiver);
        const glm::vec3 from = receiver + offset * facetNormal;
        push(tag, from, to - from, endBefore(glm::distance(from, to), offset));
    }

    // The same towards a light (Light::position()): to a point, or along a direction without end.
    void push(std::size_t tag, glm::vec3 receiver, glm::vec3 facetNormal, glm::vec4 light) {
        if (light.w != 0.0f) return push(tag, receiver, facetNormal, glm::vec3(light) / light.w);
        const glm::vec3 from = receiver + tracer_.startOffset(receiver) * facetNormal;
        push(tag, from, glm::vec3(light), std::numeric_limits<float>::infinity());
    }

    // The bare segment from + t · along, 0 < t < end.
    void push(std::size_t tag, glm::vec3 from, glm::vec3 along, float end) {
        const int i = packet_.count++;
        packet_.fromX[i] = from.x, packet_.fromY[i] = from.y, packet_.fromZ[i] = from.z;
        packet_.alongX[i] = along.x, packet_.alongY[i] = along.y, packet_.alongZ[i] = along.z;
        packet_.end[i] = end;
        tags_[i] = tag;
        if (packet_.count == SegmentPacket::kLanes) flush();
    }

    void flush() {
        if (packet_.count == 0) return;
        const std::uint32_t blocked = tracer_.blockedLanes(packet_);
        for (int i = 0; i < packet_.count; ++i) report_(tags_[i], ((blocked >> i) & 1u) != 0);
        packet_.count = 0;
    }

    // The parameter at `offset` before the end of a segment of that length.
    static float endBefore(float length, float offset) {
        return 1.0f - std::min(0.5f, offset / length);
    }

private:
    const RayTracer& tracer_;
    Report report_;
    SegmentPacket packet_;
    std::size_t tags_[SegmentPacket::kLanes] = {};
};

}  // namespace penumbra
