// What comes nearest to the ray, in the lecture's form.
#include "receiver.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, receiver.edgeRatio / field.k, 0.0); }

float softVisibility(Receiver receiver) {
    return lectureVisibility(approachOf(receiver).ratio, receiver.edgeRatio, field.k);
}
