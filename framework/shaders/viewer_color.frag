// Colour for the screen: linear light is encoded as sRGB, other images are shown as they are.
uniform sampler2D image;
uniform int encode;
in vec2 uv;
layout(location = 0) out vec4 color;

void main() {
    vec3 value = clamp(texture(image, uv).rgb, 0.0, 1.0);
    vec3 curved = 1.055 * pow(value, vec3(1.0 / 2.4)) - 0.055;
    vec3 encoded = mix(curved, 12.92 * value, vec3(lessThanEqual(value, vec3(0.0031308))));
    color = vec4(encode != 0 ? encoded : value, 1.0);
}
