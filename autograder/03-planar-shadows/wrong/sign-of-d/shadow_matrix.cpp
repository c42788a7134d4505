// Fails: Task2PlaneMatrix.ADirectionalLightTakesTheSameForm, Task2PlaneMatrix.DrawsTheExactPolygon, Task2PlaneMatrix.EntriesForAnyPlaneAndAPointLight, Task2PlaneMatrix.FlattensPointsAlongTheirRays, Task2PlaneMatrix.KeepsTheExactPolygonsArea, Task3Drawing.DarknessComesOnceUnderOverlappingCasters, Task3Drawing.NoPixelFightsWithTheReceiver, Task3Drawing.StopsAtTheReceiversEdge, Task4Clip.ACasterAboveTheLightHasNoAntishadow, Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.StraddlingTrianglesCastTheExactPolygon · the plane written as n·x = d
#include "planar_shadow.h"

namespace penumbra {

glm::mat4 groundShadowMatrix(glm::vec4 light) {
    glm::mat4 m(light.y);
    m[1] -= light;
    return m;
}

glm::mat4 planeShadowMatrix(glm::vec4 plane, glm::vec4 light) {
    plane.w = -plane.w;
    return glm::mat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

}  // namespace penumbra
