// Ray-traced visibility: the truth that every technique is compared with.
//
//   Image hard = pointVisibility(tracer, receivers, light);
//   Image soft = areaVisibility(tracer, receivers, light, 1024, &progress);
//   Image band = edgeBand(tracer, receivers, light, clipFromWorld, 1024, 1.0f);
#pragma once

#include "core/image.h"
#include "core/progress.h"
#include "truth/ray_tracer.h"

namespace penumbra {

// One channel; 1 where the camera sees no surface; 0 where the light's centre lies on or below the
// receiver's facet plane, or the receiver on or behind the light's plane.
Image pointVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light);

// The fraction of the square seen: `samples` jittered light points per pixel, stratified in the square
// (any count >= 1). Deterministic: the same seed gives the same image on any number of cores.
// Returns early, with what is done, when progress->cancelled is set.
Image areaVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light,
                     int samples, Progress* progress = nullptr, std::uint32_t seed = 1);

// 1 at receivers within `texels` texel footprints of a hard-shadow edge, measured in the shadow map
// `lightClipFromWorld` of `mapSize`² texels (by moving the light ray in the map and meeting the
// receiver's facet plane again), and where the pixel's own footprint holds another surface's edge; else 0.
// A raster shadow map cannot be right there: such pixels are counted, not graded one by one.
Image edgeBand(const RayTracer& tracer, const Receivers& receivers, const Light& light,
               const glm::mat4& lightClipFromWorld, int mapSize, float texels);

}  // namespace penumbra
