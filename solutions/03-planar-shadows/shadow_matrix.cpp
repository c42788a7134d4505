#include "planar_shadow.h"

namespace penumbra {

glm::mat4 groundShadowMatrix(glm::vec4 light) {
    glm::mat4 m(light.y);
    m[1] -= light;
    return m;
}

glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    return glm::mat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

}  // namespace penumbra
