// receiver_plane=off: the constant bias has to do.
#include "soft_shadow.glsl"

bool blocks(Receiver receiver, vec2 uv, float depth) { return receiver.uvDepth.z - depth > receiver.bias; }
