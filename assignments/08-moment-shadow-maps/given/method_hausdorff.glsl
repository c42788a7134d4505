#include "hausdorff.glsl"

Blockers blockersBefore(vec4 moments, float t) { return hausdorffBlockers(moments, t); }
