// Makers of the built-in scenes; gallery.cpp gives them their names. Same seed, same scene, on
// every system. Seed 1 is the reference that docs and study show; others vary it moderately.
//
// The standard light is a square of width 1.5 at 9.3 units from the origin, 25 degrees from the
// vertical, over a ground of 12 x 12: figures measured on these scenes can be compared.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace penumbra {

// gallery_objects.cpp: scenes whose truth is ray traced
Scene boxesScene(std::uint64_t seed);    // a box and a raised sphere
Scene fenceScene(std::uint64_t seed);    // thin posts, height rising from contact to far
Scene foliageScene(std::uint64_t seed);  // many small leaves over bumpy ground
Scene stairsScene(std::uint64_t seed);   // layers over layers: bait for light leaks

// gallery_exact.cpp: scenes whose truth is a closed form
Scene halfPlaneScene(std::uint64_t seed);
Scene polygonScene(std::uint64_t seed);
Scene tiltedScene(double incidenceDegrees);

// gallery_volumes.cpp: scenes that break shadow volumes
Scene eyeInsideScene(std::uint64_t seed);  // the eye in a volume
Scene nearCutScene(std::uint64_t seed);    // the eye outside, the near rectangle half inside
Scene nestedScene(double sheets);          // so many volumes around one receiver
Scene sunScene(std::uint64_t seed);        // a directional light
Scene lampScene(std::uint64_t seed);       // the light in a cage
Scene shutLampScene(std::uint64_t seed);   // the light in a closed globe
Scene openMeshScene(std::uint64_t seed);   // meshes that are no solids

// gallery_planar.cpp: the receiver comes first, an open sheet; casters are closed
Scene boardScene(double tiltDegrees);   // a tilted, finite plane
Scene hollowScene(std::uint64_t seed);  // a curved receiver, part of it behind the light
Scene mastScene(std::uint64_t seed);    // casters above the light and below the ground

// gallery_courtyard.cpp
Scene courtyardScene(std::uint64_t seed);  // 10 lights, 48 casters

inline constexpr float kStandardLightWidth = 1.5f;
inline constexpr float kStandardLightDistance = 9.3f;

// At the standard distance from the origin and facing it; azimuth from +x towards +z. Radians.
Light standardLight(float azimuth, float tilt = 0.4363323f);

// Near and far planes just outside the scene's depth range, near at least a 25th of far (the ground
// may pass under the camera).
void fitDepthRange(Scene& scene);

}  // namespace penumbra
