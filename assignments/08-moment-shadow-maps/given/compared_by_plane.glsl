// receiver_plane=on
#include "moment_soft.glsl"

float comparedWith(Receiver receiver, float blockerDepth) { return comparedDepth(receiver, blockerDepth); }
