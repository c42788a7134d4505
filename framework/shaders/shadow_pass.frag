// Visibility of each pixel's receiver, and the picture with it.
#include "receivers.glsl"

layout(location = 0) out vec4 color;
layout(location = 1) out float visibility;

float receiverVisibility(ivec2 pixel);  // of a surface before the light

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float kind = texelFetch(receiverPosition, pixel, 0).w;
    visibility = kind < 0.0 ? 1.0 : 0.0;
    if (kind > 0.0) visibility = receiverVisibility(pixel);
    color = texelFetch(unlitColor, pixel, 0) + visibility * texelFetch(directColor, pixel, 0);
}
