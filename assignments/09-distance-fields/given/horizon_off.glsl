#include "receiver.glsl"

float lightAboveHorizon(Receiver receiver) { return 1.0; }
