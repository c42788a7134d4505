// Fails: Task2ReceiverPlane.NoFalseShadowOnAPlaneFrom10To89Degrees, Task3Pcf.ComparesFirstAndFiltersTheAnswers, Task5Pcss.AHalfPlanesPenumbraIsALinearRamp, Task5Pcss.FiltersAsTheSearchSays, Task5Pcss.TheHorizonIsCountedOnce, Task8WholeShadow.BoxesAgreeWithRays, Task8WholeShadow.FenceAgreesWithRays, Task8WholeShadow.FoliageAgreesWithRays, Task8WholeShadow.StairsAgreeWithRays · depths are averaged, and the mean is compared
#include "soft_shadow.glsl"

float percentageCloser(Receiver receiver, vec2 widthUv) {
    float inverse = 1.0 / float(soft.filterSamples), sum = 0.0;
    for (int j = 0; j < soft.filterSamples; ++j)
        for (int i = 0; i < soft.filterSamples; ++i) {
            vec2 point = kernelPoint(vec2(i, j), inverse);
            vec2 uv = receiver.uvDepth.xy + point * widthUv;
            sum += storedDepth(uv);
        }
    return blocks(receiver, receiver.uvDepth.xy, sum * inverse * inverse) ? 0.0 : 1.0;
}
