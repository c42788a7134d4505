// Ray-traced visibility: the truth that every technique is compared with.
//
//   Image hard = pointVisibility(tracer, receivers, light);
//   Image soft = areaVisibility(tracer, receivers, light, 1024, &progress);
//   Image band = edgeBand(tracer, receivers, light, clipFromWorld, 1024, 1.0f);
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/progress.h"
#include "truth/ray_tracer.h"

namespace penumbra {

// One channel; 1 where the camera sees no surface; 0 where the light's centre lies on or below the
// receiver's facet plane, or the receiver on or behind the light's plane or as far as its range. A
// directional light has no plane and no range; it lies below a facet where dot(normal, -forward)
// is not above 0.
Image pointVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light);

// The fraction of the square seen (of a directional light: pointVisibility's): `samples` jittered
// light points per pixel, stratified in the square (any count >= 1). Deterministic: the same seed
// gives the same image on any number of cores. Advances `progress` by one a row. Returns early when
// progress->cancelled is set: rows not yet done are 1.
Image areaVisibility(const RayTracer& tracer, const Receivers& receivers, const Light& light,
                     int samples, Progress* progress = nullptr, std::uint32_t seed = 1);

// Upper bound of the noise of areaVisibility's image: the root mean square over all pixels of the
// standard error sqrt(V (1-V) / (samples - 1)) that independent samples would have. Strata only
// lower it (along a straight edge to about samples^-3/4). One sample tells nothing of its own
// noise: 1/2, the largest value.
double standardError(const Image& visibility, int samples);

// 1 at receivers within `texels` texel footprints of a hard-shadow edge, measured in the shadow map
// `lightClipFromWorld` of `mapSize`² texels (by moving the light ray in the map and meeting the
// receiver's facet plane again; for a directional light the map's projection is
// orthographic), and where the pixel's own footprint holds another surface's edge;
// else 0. A raster shadow map cannot be right there: such pixels are counted, not graded one by
// one.
//
// Rays are moved to the 8 neighbours of a grid of half-texel rings, so a shadow thinner than half a
// texel may slip through. A moved point may lie past the end of the receiver's surface; what it
// meets there still marks the pixel: the band errs on the side of marking too much.
Image edgeBand(const RayTracer& tracer, const Receivers& receivers, const Light& light,
               const glm::mat4& lightClipFromWorld, int mapSize, float texels);

}  // namespace penumbra
