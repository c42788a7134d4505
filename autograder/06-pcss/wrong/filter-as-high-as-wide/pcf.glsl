// Fails: Task5Pcss.FiltersAsTheSearchSays · the filter is as high as it is wide, in uv
#include "soft_shadow.glsl"

float percentageCloser(Receiver receiver, vec2 widthUv) {
    float inverse = 1.0 / float(soft.filterSamples), lit = 0.0;
    for (int j = 0; j < soft.filterSamples; ++j)
        for (int i = 0; i < soft.filterSamples; ++i) {
            vec2 point = kernelPoint(vec2(i, j), inverse);
            vec2 uv = receiver.uvDepth.xy + point * widthUv.x;
            bool blocked = blocks(receiver, uv, storedDepth(uv));
            lit += aboveHorizon(receiver, point) && !blocked ? 1.0 : 0.0;
        }
    return lit * inverse * inverse;
}
