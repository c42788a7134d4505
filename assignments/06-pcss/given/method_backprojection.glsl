#include "hidden_area.glsl"

float softVisibility(Receiver receiver) { return backprojectedVisibility(receiver); }
