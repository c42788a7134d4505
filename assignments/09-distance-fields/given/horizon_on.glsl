#include "receiver.glsl"
#include "light_share.glsl"

float lightAboveHorizon(Receiver receiver) { return shareAboveHorizon(receiver.lightHeight); }
