// Vertices of shadow volumes: as they are (w = 1), or sent to infinity (w = 0).
#include "clip_position.glsl"
#include "extrude.glsl"
#include "light.glsl"

layout(location = 0) in vec4 vertex;

void main() { gl_Position = clipPosition(vertex.w > 0.0 ? vertex : extruded(vertex.xyz, light.position)); }
