// Exact visibility of a whole picture, for the built-in scenes that have a closed form.
//
//   if (auto exact = exactVisibility(scene, receivers)) …   // else: rays (truth/visibility.h)
#pragma once

#include <optional>

#include "core/image.h"
#include "scene/scene.h"
#include "truth/ray_tracer.h"

namespace penumbra {

// Of the scene's first light as a square, one channel, 1 where the camera sees no surface; for
// `halfplane`, `polygon` and `tilted` of any number: at most one convex polygon over bare ground.
// None for other scenes and for directional lights.
std::optional<Image> exactVisibility(const Scene& scene, const Receivers& receivers);

}  // namespace penumbra
