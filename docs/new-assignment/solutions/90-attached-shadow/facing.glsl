float facingVisibility(vec3 facet, vec3 toLight) { return dot(facet, toLight) > 0.0 ? 1.0 : 0.0; }
