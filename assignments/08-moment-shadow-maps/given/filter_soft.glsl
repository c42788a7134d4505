#include "msm.glsl"

float filteredVisibility(Receiver receiver) { return momentVisibility(receiver); }
