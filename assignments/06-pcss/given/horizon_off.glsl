#include "soft_shadow.glsl"

bool aboveHorizon(Receiver receiver, vec2 lightPoint) { return true; }
