// Casters are black on a white background.
in vec2 surfaceUv;
layout(location = 0) out float texel;

bool isMissing(vec2 uv);  // opaque.glsl or masked.glsl

void main() {
    if (isMissing(surfaceUv)) discard;
    texel = 0.0;
}
