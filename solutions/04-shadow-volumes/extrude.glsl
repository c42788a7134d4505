vec4 extruded(vec3 p, vec4 light) { return vec4(light.w * p - light.xyz, 0.0); }
