// On which side of a triangle a light lies: the exact sign of a 4 x 4 determinant. Silhouettes need
// it exact: two triangles that share an edge must never be told different stories about one plane.
//
//   int side = orientation(a, b, c, light.position());        // homogeneous: w = 1, or 0 far away
//   bool facing = side > 0;    // the light sees a, b, c counter-clockwise
//   bool inPlane = side == 0;  // or the triangle has no area: no volume either way
#pragma once

#include <glm/glm.hpp>

namespace penumbra {

//                          | a.x      a.y      a.z      1       |
//   orientation =  - sign  | b.x      b.y      b.z      1       |  = sign n · (light.xyz - light.w
//   a),
//                          | c.x      c.y      c.z      1       |        n = (b - a) x (c - a)
//                          | light.x  light.y  light.z  light.w |
//
// +1, 0 or -1; exact for all finite floats, denormal ones too (but a thread in denormal-flushing
// mode, such as parallelFor's, sees those as 0). Hence: swapping two corners turns the sign,
// turning the corners around keeps it, and so does scaling everything by a power of two that loses
// no bits.
int orientation(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec4 light);

}  // namespace penumbra
