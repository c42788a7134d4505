#include "hamburger.glsl"

Blockers blockersBefore(vec4 moments, float t) { return hamburgerBlockers(moments, t); }
