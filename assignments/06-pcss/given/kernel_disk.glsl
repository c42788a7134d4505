#include "kernels.glsl"

vec2 kernelPoint(vec2 cell, float inverse) { return diskFromSquare(shearedGrid(cell, inverse)); }
