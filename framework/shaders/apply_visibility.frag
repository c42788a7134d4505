// The picture, from a visibility that was made elsewhere.
#include "receivers.glsl"

uniform sampler2D visibilityImage;
layout(location = 0) out vec4 color;
layout(location = 1) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    visibility = texelFetch(visibilityImage, pixel, 0).r;
    color = texelFetch(unlitColor, pixel, 0) + visibility * texelFetch(directColor, pixel, 0);
}
