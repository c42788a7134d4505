// Counts in a float target by blending: no wrap, and a sign.
uniform float frontStep;
uniform float backStep;
layout(location = 0) out float count;

void main() { count = gl_FrontFacing ? frontStep : backStep; }
