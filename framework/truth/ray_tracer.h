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

// What the camera sees through each pixel's centre. Row 0 is the top row.
struct Receivers {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> facetNormals;  // geometric, unit, on the eye's side
    std::vector<std::uint8_t> hit;        // 0 = background
};

class RayTracer {
public:
    explicit RayTracer(const Scene& scene);
    ~RayTracer();
    RayTracer(RayTracer&&) noexcept;
    RayTracer& operator=(RayTracer&&) noexcept;

    Receivers receivers(const Camera& camera, glm::ivec2 size) const;

    // blocked[i] = 1 where something stands strictly between from[i] and to[i]. The receiver's own
    // facet never blocks it (see the .cpp for how the start is offset). Alpha-masked holes let light pass.
    void occluded(std::span<const glm::vec3> from, std::span<const glm::vec3> fromNormals,
                  std::span<const glm::vec3> to, std::span<std::uint8_t> blocked) const;

    // First depth in [0,1] (OpenGL window depth, before any depth format rounds it) seen through each
    // texel's centre of the view `clipFromWorld`; 1 where nothing is. One channel, row 0 on top.
    Image depth(const glm::mat4& clipFromWorld, glm::ivec2 size) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace penumbra
