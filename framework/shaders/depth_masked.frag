#include "material.glsl"

in vec2 surfaceUv;

void main() {
    if (isHole(surfaceUv)) discard;
}
