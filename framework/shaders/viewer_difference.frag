// image - truth: blue where too dark, white where equal, red where too light, as falseColorDifference().
uniform sampler2D image;
uniform sampler2D truth;
in vec2 uv;
layout(location = 0) out vec4 color;

void main() {
    float d = clamp(texture(image, uv).r - texture(truth, uv).r, -1.0, 1.0);
    color = vec4(d < 0.0 ? 1.0 + d : 1.0, 1.0 - abs(d), d > 0.0 ? 1.0 - d : 1.0, 1.0);
}
