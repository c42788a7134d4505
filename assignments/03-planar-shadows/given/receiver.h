// Which mesh of a scene the shadows fall on, its plane, and everything else: the casters.
//
//   const std::size_t receiver = receiverOf(scene);
//   std::optional<vec4> plane = planeOf(scene.meshes[receiver]);   // none: it is not flat
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "scene/scene.h"

namespace penumbra {

// The mesh called "receiver", else the one called "ground", else the one with the largest surface.
std::size_t receiverOf(const Scene& scene);

// (n, d) with unit n and n·p + d = 0 for every vertex p, to within 2^-20 of the largest coordinate
// (what turning and moving in float32 leaves of a plane); none for a mesh that is not flat.
std::optional<glm::vec4> planeOf(const Mesh& mesh);

// Some meshes of a scene, to be drawn without colour: textures are kept only where masks need them.
Scene withoutColor(const Scene& scene, std::vector<Mesh> meshes);

// Turned about the z direction through the middle of its bounding box.
void tilt(Mesh& mesh, float angleRadians);

}  // namespace penumbra
