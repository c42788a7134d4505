// One channel as grey, range.x black and range.y white. Not clamped: a float target gets the value itself.
uniform sampler2D image;
uniform vec2 range;
in vec2 uv;
layout(location = 0) out vec4 color;

void main() { color = vec4(vec3((texture(image, uv).r - range.x) / (range.y - range.x)), 1.0); }
