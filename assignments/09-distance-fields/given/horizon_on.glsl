#include "receiver.glsl"
#include "horizon.glsl"

float lightAboveHorizon(Receiver receiver) { return shareAboveHorizon(receiver.lightHeight); }
