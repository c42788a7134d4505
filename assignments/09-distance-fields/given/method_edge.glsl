// One ray, and the line that the nearest edge draws across the light.
#include "edge_line.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, surelyLit(receiver), -surelyLit(receiver)); }

float softVisibility(Receiver receiver) {
    float most = surelyLit(receiver);
    return shareAboveHorizon(edgeLine(receiver, receiver.direction, approachOf(receiver), most, -most).height);
}
