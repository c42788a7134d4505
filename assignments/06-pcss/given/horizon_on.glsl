#include "soft_shadow.glsl"
#include "receiver_plane.glsl"

bool aboveHorizon(Receiver receiver, vec2 lightPoint) { return isAboveHorizon(receiver.lightHeight, lightPoint); }
