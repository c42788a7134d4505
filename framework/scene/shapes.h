// Triangle meshes of simple shapes, for built-in scenes and tests.
//
//   scene.meshes.push_back(box({-1, 0, -1}, {1, 2, 1}, material));
#pragma once

#include "scene/scene.h"

namespace penumbra {

// Counter-clockwise seen from outside; normals point out; every facet has its own vertices.
Mesh box(glm::vec3 lower, glm::vec3 upper, int material);
// a, b, c, d counter-clockwise seen from the side its normal points to; uv (0,0) (1,0) (1,1) (0,1).
Mesh quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, int material);
// Latitude-longitude sphere with smooth normals; `rings` >= 2, 2 · rings segments around.
Mesh sphere(glm::vec3 center, float radius, int rings, int material);
// The square ground of full width `size` around the origin in the plane y = 0, as cells x cells
// quads.
Mesh ground(float size, int cells, int material);

// Turned on a lathe: the outline's points are (radius, height) over `foot`, from the axis at the
// bottom around the outside to the axis at the top. Closed. Smooth around, hard at the outline's
// corners.
Mesh lathe(glm::vec3 foot, const std::vector<glm::vec2>& outline, int segments, int material);
Mesh cylinder(glm::vec3 foot, float radius, float height, int segments, int material);
// Around a vertical axis, smooth; `ring` from the center to the tube's middle.
Mesh torus(glm::vec3 center, float ring, float tube, int segments, int tubeSegments, int material);
// The upper half of a flat ring that stands on its two ends at `center` ± (inner … outer) along x
// and is `depth` thick along z. Closed.
Mesh arch(glm::vec3 center, float inner, float outer, float depth, int segments, int material);

// Appends `other` to `mesh`; both with or both without uvs.
void append(Mesh& mesh, const Mesh& other);

}  // namespace penumbra
