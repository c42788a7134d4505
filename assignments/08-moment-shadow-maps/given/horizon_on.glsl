// The part of the light over the receiver's plane: where height.x + s height.y + t height.z > 0, s and t in [-1/2, 1/2].
#include "light_share.glsl"

// The rectangle (low, high) around that part: as far as the light reaches against the slope, at its best other side.
vec4 lightRectangle(vec3 height) {
    vec2 slope = height.yz, best = height.x + 0.5 * abs(slope.yx);
    vec2 steep = max(abs(slope), 1e-6 * (abs(height.x) + abs(slope.x) + abs(slope.y)));
    vec2 reach = clamp(best / steep, -0.5, 0.5);  // how far it goes down from the middle
    return vec4(mix(vec2(-0.5), -reach, greaterThan(slope, vec2(0.0))), mix(vec2(0.5), reach, lessThan(slope, vec2(0.0))));
}

float lightShare(vec3 height) { return shareAboveHorizon(height); }
