#include "each_box.glsl"
#include "mip_levels.glsl"

uniform sampler2D moments;

vec2 meanInside(vec2 low, vec2 high) { return mipMean(moments, low, high).xy; }
