// Scene and volumes go to the screen through this one expression, so that a cap has the depth of the surface
// that it lies on to the last bit.
#include "camera.glsl"

invariant gl_Position;

vec4 clipPosition(vec4 world) { return camera.clipFromWorld * world; }
