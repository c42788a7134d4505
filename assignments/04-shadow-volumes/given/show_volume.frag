// A volume's surface, translucent: warm where a view ray enters it, cool where it leaves.
uniform bool inward;
layout(location = 0) out vec4 color;

void main() {
    vec3 warm = vec3(1.0, 0.45, 0.05), cool = vec3(0.05, 0.3, 1.0);
    color = vec4(gl_FrontFacing != inward ? warm : cool, 0.2);
}
