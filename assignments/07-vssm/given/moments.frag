#include "variance_shadow.glsl"
#include "moments.glsl"

layout(location = 0) out vec2 moments;

void main() { moments = momentsFromDepth(texelFetch(shadowMap, ivec2(gl_FragCoord.xy), 0).r, shadow.center); }
