// Which meshes can cast a shadow on anything at all: the ground that everything stands on cannot.
//
//   std::vector<Mesh> blockers = possibleBlockers(scene, scene.lights[0]);
#pragma once

#include <vector>

#include "scene/scene.h"

namespace penumbra {

// A triangle cannot block any light if
// - the whole light and all receivers lie on one side of its plane or in it (within float32
//   rounding): a segment between them does not cross the plane; or
// - it lies on or behind the light's plane, where no segment goes.
// Receivers are the corners of all triangles of the scene, but for those of closed meshes that face
// away from the whole light: seen from outside, visibility is 0 there whatever the blockers are. (A
// mesh around the light or inside out has no such triangles: it is seen from inside.)
//
// A mesh stays whole, so that a closed one stays closed, if any of its triangles can block.
std::vector<Mesh> possibleBlockers(const Scene& scene, const Light& light);

}  // namespace penumbra
