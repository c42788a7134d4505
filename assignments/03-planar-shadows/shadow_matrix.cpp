#include "planar_shadow.h"

namespace penumbra {

// Task 1 · the matrix that flattens the world onto the plane y = 0.       README §1, [Blinn 1988]
//   light   homogeneous: (l, 1) at the point l, or (direction to the light, 0)
// Returns M with M (v, 1) = (p w, w): p is where the ray from the light through v meets y = 0, and
// w is the light's height less v's (for a point light), in world units. glm stores columns:
// m[column][row].
glm::mat4 groundShadowMatrix(glm::vec4 light) {
    (void)light;
    return glm::mat4(0.0f);  // yours; a matrix of zeros draws nothing
}

// Task 2 · the same for any plane.                                                     README §2
//   plane   (n, d) with n·x + d = 0 for its points x; n need not be unit
//   light   as above, on the side that n points to: n·l + d l_w > 0
// Returns M with M (v, 1) = (p w, w), in one form for both kinds of light; w = n·(l - l_w v). For
// the plane (0, 1, 0, 0) it equals groundShadowMatrix(), entry by entry.
glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    (void)plane, (void)light;
    return glm::mat4(0.0f);  // yours
}

}  // namespace penumbra
