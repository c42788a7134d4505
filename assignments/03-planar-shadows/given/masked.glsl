#include "material.glsl"

bool isMissing(vec2 uv) { return isHole(uv); }
