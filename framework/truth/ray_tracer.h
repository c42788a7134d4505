// Ray-traced geometry with Embree (robust mode): what a pixel sees, and whether a segment is free.
//
//   RayTracer tracer(scene);
//   Receivers receivers = tracer.receivers(scene.camera, {512, 512});
//   Image truth = areaVisibility(tracer, receivers, scene.lights[0], 256);   // visibility.h
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/image.h"
#include "scene/scene.h"

namespace penumbra {

// What the camera sees through each pixel's centre, between its near and far planes. Row 0 is the
// top row.
struct Receivers {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> facetNormals;  // geometric, unit, on the eye's side
    std::vector<std::uint8_t> hit;        // 0 = background
};

// Sixteen segments side by side, for loops that trace millions: from + t · along, 0 < t < end.
// Lanes at and past `count` are ignored.
struct alignas(64) SegmentPacket {
    static constexpr int kLanes = 16;
    float fromX[kLanes] = {}, fromY[kLanes] = {}, fromZ[kLanes] = {};
    float alongX[kLanes] = {}, alongY[kLanes] = {}, alongZ[kLanes] = {};
    float end[kLanes] = {};
    int count = 0;
};

class RayTracer {
public:
    explicit RayTracer(const Scene& scene);
    ~RayTracer();
    RayTracer(RayTracer&&) noexcept;
    RayTracer& operator=(RayTracer&&) noexcept;

    Receivers receivers(const Camera& camera, glm::ivec2 size) const;

    // blocked[i] = 1 where something stands strictly between from[i] and to[i]. The receiver's own
    // facet never blocks it: the segment starts at from + startOffset(from) · normal, so `to`
    // should lie above the facet's plane. Alpha-masked holes let light pass. On all cores.
    void occluded(std::span<const glm::vec3> from, std::span<const glm::vec3> fromNormals,
                  std::span<const glm::vec3> to, std::span<std::uint8_t> blocked) const;

    // Bit i is set where lane i's segment is blocked. One thread; starts are taken as they are.
    std::uint32_t blockedLanes(const SegmentPacket& packet) const;

    // How far above its facet a segment must start so that rounding cannot let the facet block it
    // [world]: some ulps of the coordinates that enter Embree's arithmetic, hence proportional to
    // the scene: about 2e-6 of its diagonal.
    float startOffset(glm::vec3 position) const;

    // First depth in [0,1] (OpenGL window depth, before any depth format rounds it) seen through
    // each texel's centre of the view `clipFromWorld`; 1 where nothing is. One channel, row 0 on
    // top. The far plane may lie at infinity.
    Image depth(const glm::mat4& clipFromWorld, glm::ivec2 size) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace penumbra
