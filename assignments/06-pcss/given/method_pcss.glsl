#include "pcss.glsl"

float softVisibility(Receiver receiver) { return pcssVisibility(receiver); }
