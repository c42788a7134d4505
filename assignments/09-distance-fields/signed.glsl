#include "lecture.glsl"

float signedVisibility(float ratio, float edgeRatio) { return clamp(0.5 + 0.5 * safeTangent(ratio) / edgeRatio, 0.0, 1.0); }
