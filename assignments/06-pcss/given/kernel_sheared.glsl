#include "kernels.glsl"

vec2 kernelPoint(vec2 cell, float inverse) { return shearedGrid(cell, inverse); }
