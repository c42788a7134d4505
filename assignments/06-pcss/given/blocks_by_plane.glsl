// receiver_plane=on. The plane's depth is asked for where the texel was sampled: at its centre.
#include "soft_shadow.glsl"
#include "receiver_plane.glsl"

bool blocks(Receiver receiver, vec2 uv, float depth) {
    return isBlocker(receiver.plane, vec3(texelCenter(uv), depth) - receiver.uvDepth, receiver.bias);
}
