// Fails: Task1GroundMatrix.ADirectionalLightTakesTheSameForm, Task1GroundMatrix.DrawsTheExactPolygon, Task1GroundMatrix.EntriesAreTheLecturesForAPointLight, Task1GroundMatrix.FlattensPointsAlongTheirRays, Task2PlaneMatrix.ADirectionalLightTakesTheSameForm, Task2PlaneMatrix.DrawsTheExactPolygon, Task2PlaneMatrix.EntriesForAnyPlaneAndAPointLight, Task2PlaneMatrix.EqualsTheGroundMatrixForTheGround, Task2PlaneMatrix.FlattensPointsAlongTheirRays, Task2PlaneMatrix.KeepsTheExactPolygonsArea, Task3Drawing.DarknessComesOnceUnderOverlappingCasters, Task3Drawing.NoPixelFightsWithTheReceiver, Task3Drawing.NothingIsDrawnOverCasters, Task3Drawing.StopsAtTheReceiversEdge, Task4Clip.ACasterAboveTheLightHasNoAntishadow, Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.StraddlingTrianglesCastTheExactPolygon · rows written where glm stores columns
#include "planar_shadow.h"

namespace penumbra {

glm::mat4 groundShadowMatrix(glm::vec4 light) {
    glm::mat4 m(light.y);
    for (int column = 0; column < 4; ++column) m[column][1] -= light[column];
    return m;
}

glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    return glm::mat4(glm::dot(plane, light)) - glm::outerProduct(plane, light);
}

}  // namespace penumbra
