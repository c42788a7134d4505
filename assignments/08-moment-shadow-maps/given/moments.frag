// Each texel's depth as moments, in the form in which they are kept.
#include "moments.glsl"

uniform sampler2D depths;
layout(location = 0) out vec4 stored;

vec4 storedMoments(vec4 moments);  // storage

void main() { stored = storedMoments(depthMoments(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r)); }
