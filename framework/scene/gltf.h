// glTF 2.0 files (.glb, .gltf) to and from a Scene.
//
//   Scene scene = loadGltf("chair.glb");
//   saveGlb("copy.glb", scene);
//
// Read: node hierarchy (flattened to world space), triangles, strips and fans, indexed or not,
// 8/16/32-bit indices, missing normals (area-weighted averages), several primitives and materials,
// base colour factors and textures, alpha masks, emissive factors
// (KHR_materials_emissive_strength), KHR_lights_punctual (directional lights; range; extras.width =
// full width in metres of a square area light that faces along the node's -Z, edges along its X and
// Y), cameras. Where a file has no camera or no light, sensible ones are placed. Left out:
// animation, skins, emissive textures, other extensions.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace penumbra {

// Throws Error, one line naming what and where, for any file it cannot trust: out-of-range indices,
// cyclic nodes, non-finite positions, truncated buffers, Draco, …
Scene loadGltf(const std::filesystem::path& path);

// One node a mesh, materials and textures (embedded PNG), the camera and the lights. What is saved
// loads back equal: positions bit for bit; a directional light keeps its `center` where the whole
// scene lies in front of it. Throws Error when the file cannot be written.
void saveGlb(const std::filesystem::path& path, const Scene& scene);

// A camera and an area light that show the scene's shadow well; used where a file has none.
Camera sensibleCamera(const Box& box);
Light sensibleLight(const Box& box);

}  // namespace penumbra
