// The light's centre alone.
#include "receiver.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, 1e-4, 0.0); }

float softVisibility(Receiver receiver) { return approachOf(receiver).ratio > 0.0 ? 1.0 : 0.0; }
