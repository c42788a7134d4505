// receiver_plane=off: the constant bias has to do.
#include "moment_shadow.glsl"

float comparedWith(Receiver receiver, float blockerDepth) { return receiver.uvDepth.z - receiver.bias; }
