// One width for all receivers.
#include "filter.glsl"

float softVisibility(Receiver receiver) {
    float wholeLight = shareAboveHorizon(receiver, vec2(0.0), 1.0);
    if (receiver.lightHeight.x <= 0.0) return wholeLight;
    return visibilityInWindow(receiver, shadow.filterWidthUv);
}
