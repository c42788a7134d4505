// Fails: Task3Drawing.DarknessComesOnceUnderOverlappingCasters, Task3Drawing.NoPixelFightsWithTheReceiver, Task3Drawing.StopsAtTheReceiversEdge, Task4Clip.ACasterAboveTheLightHasNoAntishadow, Task4Clip.ACasterBehindThePlaneHasNoFalseShadow, Task4Clip.StraddlingTrianglesCastTheExactPolygon, Task5RayForm.DrawsTheExactPolygon, Task7WholeShadow.FenceAgreesWithRays, Task7WholeShadow.HugeAndTinyScenesCastTheSameShadow, Task7WholeShadow.LowLightsCastLongShadows, Task7WholeShadow.StairsAgreeWithRays · the flattened casters are depth tested against the plane they lie in
#include "planar_shadow.h"

namespace penumbra {

DrawState receiverDrawing() { return {.stencilReference = 1, .passes = GL_REPLACE}; }

DrawState shadowDrawing() {
    return {.stencilFunction = GL_EQUAL, .stencilReference = 1, .passes = GL_ZERO};
}

}  // namespace penumbra
