// image - truth: blue where too dark, red where too light, as falseColorDifference(); where they agree a
// faint picture of the truth, for orientation.
uniform sampler2D image;
uniform sampler2D truth;
in vec2 uv;
layout(location = 0) out vec4 color;

void main() {
    float expected = texture(truth, uv).r;
    float d = clamp(texture(image, uv).r - expected, -1.0, 1.0);
    vec3 agreed = vec3(mix(0.80, 0.97, clamp(expected, 0.0, 1.0)));
    vec3 wrong = d < 0.0 ? vec3(0.05, 0.20, 0.95) : vec3(0.93, 0.12, 0.08);
    color = vec4(mix(agreed, wrong, abs(d)), 1.0);
}
