// How deep the ray goes counts, too.
#include "receiver.glsl"
#include "signed.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, receiver.edgeRatio, -receiver.edgeRatio); }

float softVisibility(Receiver receiver) { return signedVisibility(approachOf(receiver).ratio, receiver.edgeRatio); }
