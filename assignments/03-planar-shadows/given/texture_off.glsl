float castVisibility(vec3 worldPosition) { return 1.0; }
