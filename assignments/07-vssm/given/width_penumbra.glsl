// A receiver whose plane turns away from the light's centre is given the light above its horizon: a map's moments cannot
// tell the plane itself, which then stands before it, from what blocks.
#include "vssm.glsl"

float softVisibility(Receiver receiver) {
    float wholeLight = shareAboveHorizon(receiver, vec2(0.0), 1.0);
    if (receiver.lightHeight.x <= 0.0) return wholeLight;
    return vssmVisibility(receiver);
}
