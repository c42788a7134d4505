// receiver_plane=on
#include "receiver_plane.glsl"

float comparedWith(Receiver receiver, float blockerDepth) { return comparedDepth(receiver, blockerDepth); }
