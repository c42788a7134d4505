vec4 lightRectangle(vec3 height) { return vec4(-0.5, -0.5, 0.5, 0.5); }

float lightShare(vec3 height) { return 1.0; }
