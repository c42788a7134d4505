vec4 biasedLightClip(vec4 lightClip, vec3 facet, float cosTheta, float lightDistance) { return lightClip; }
