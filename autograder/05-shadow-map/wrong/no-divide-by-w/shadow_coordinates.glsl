// Fails: TBD · no divide by w: right only for a directional light
vec4 lightClipPosition(vec3 world, mat4 clipFromWorld) { return clipFromWorld * vec4(world, 1.0); }

vec3 shadowMapUvDepth(vec4 lightClip) { return 0.5 * lightClip.xyz + 0.5; }
