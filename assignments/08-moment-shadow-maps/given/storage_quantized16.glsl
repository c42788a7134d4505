#include "quantize.glsl"

vec4 storedMoments(vec4 moments) { return quantizedMoments(moments); }

vec4 momentsFromStored(vec4 stored) { return dequantizedMoments(stored); }
