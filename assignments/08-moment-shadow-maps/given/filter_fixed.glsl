// One box for all receivers: soft, and equally soft everywhere.
#include "window.glsl"
#include "quantize.glsl"

float filteredVisibility(Receiver receiver) {
    vec4 box = receiver.uvDepth.xyxy + 0.5 * soft.filterWidthUv.xyxy * vec4(-1.0, -1.0, 1.0, 1.0);
    vec4 moments = biasedMoments(meanMoments(box), soft.momentBias);
    return receiver.lightShare * (1.0 - blockersBefore(moments, 2.0 * (receiver.uvDepth.z - receiver.bias) - 1.0).share);
}
