#include "moment_soft.glsl"

float filteredVisibility(Receiver receiver) { return momentVisibility(receiver); }
