// Visibility of each pixel's receiver, and the picture with it.
#include "receiver.glsl"

uniform sampler2D unlitColor;
uniform sampler2D directColor;
layout(location = 0) out vec4 color;
layout(location = 1) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float kind;
    Receiver receiver = receiverAt(pixel, kind);
    visibility = kind < 0.0 ? 1.0 : 0.0;
    if (kind > 0.0) visibility = softVisibility(receiver);
    color = texelFetch(unlitColor, pixel, 0) + visibility * texelFetch(directColor, pixel, 0);
}
