// One width for all receivers.
#include "filter.glsl"

float softVisibility(Receiver receiver) {
    if (receiver.lightHeight.x <= 0.0) return shareAboveHorizon(receiver, vec2(0.0), 1.0);
    return visibilityInWindow(receiver, shadow.filterWidthUv);
}
