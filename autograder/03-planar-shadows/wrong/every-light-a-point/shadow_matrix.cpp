// Fails: Task1GroundMatrix.ADirectionalLightTakesTheSameForm, Task1GroundMatrix.DrawsTheExactPolygon, Task1GroundMatrix.FlattensPointsAlongTheirRays, Task2PlaneMatrix.ADirectionalLightTakesTheSameForm, Task2PlaneMatrix.DrawsTheExactPolygon, Task2PlaneMatrix.EqualsTheGroundMatrixForTheGround, Task2PlaneMatrix.FlattensPointsAlongTheirRays, Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.StraddlingTrianglesCastTheExactPolygon · l_w taken as 1: a direction becomes a point one unit from the origin
#include "planar_shadow.h"

namespace penumbra {

glm::mat4 groundShadowMatrix(glm::vec4 light) {
    light.w = 1.0f;
    glm::mat4 m(light.y);
    m[1] -= light;
    return m;
}

glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    light.w = 1.0f;
    return glm::mat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

}  // namespace penumbra
