// For prefilters that look up whole boxes.
#include "variance_shadow.glsl"

vec2 meanInside(vec2 low, vec2 high);  // over a box inside the map [texels]

Side sideAt(vec2 low, vec2 high) { return Side(low, high, vec2(0.0), vec2(0.0)); }

Side wholeSideAt(vec2 low, vec2 high) { return sideAt(low, high); }

vec2 meanBetween(Side left, Side right) { return meanInside(left.low, right.high); }
