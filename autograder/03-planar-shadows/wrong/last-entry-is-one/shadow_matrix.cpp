// Fails: Task1GroundMatrix.ADirectionalLightTakesTheSameForm, Task1GroundMatrix.DrawsTheExactPolygon, Task1GroundMatrix.EntriesAreTheLecturesForAPointLight, Task1GroundMatrix.FlattensPointsAlongTheirRays · the last row of an affine matrix: flattens along the plane's normal only
#include "planar_shadow.h"

namespace penumbra {

glm::mat4 groundShadowMatrix(glm::vec4 light) {
    glm::mat4 m(1.0f);
    m[1] = {-light.x / light.y, 0.0f, -light.z / light.y, 0.0f};
    return m;
}

glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    return glm::mat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

}  // namespace penumbra
