// Fails: Task1GroundMatrix.ADirectionalLightTakesTheSameForm, Task1GroundMatrix.DrawsTheExactPolygon, Task1GroundMatrix.EntriesAreTheLecturesForAPointLight, Task1GroundMatrix.FlattensPointsAlongTheirRays, Task2PlaneMatrix.ADirectionalLightTakesTheSameForm, Task2PlaneMatrix.DrawsTheExactPolygon, Task2PlaneMatrix.EntriesForAnyPlaneAndAPointLight, Task2PlaneMatrix.EqualsTheGroundMatrixForTheGround, Task2PlaneMatrix.FlattensPointsAlongTheirRays, Task3Drawing.DarknessComesOnceUnderOverlappingCasters, Task3Drawing.NoPixelFightsWithTheReceiver, Task3Drawing.NothingIsDrawnOverCasters, Task3Drawing.StopsAtTheReceiversEdge, Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.StraddlingTrianglesCastTheExactPolygon · light planeᵀ - (plane·light) I: the same points with w < 0, which the rasteriser cuts off
#include "planar_shadow.h"

namespace penumbra {

glm::mat4 groundShadowMatrix(glm::vec4 light) {
    glm::mat4 m(-light.y);
    m[1] += light;
    return m;
}

glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    return glm::outerProduct(light, plane) - glm::mat4(glm::dot(plane, light));
}

}  // namespace penumbra
