// The part of the light over the receiver's plane: where height.x + s height.y + t height.z > 0, s and t in [-1/2, 1/2].

// The rectangle (low, high) around that part: as far as the light reaches against the slope, at its best other side.
vec4 lightRectangle(vec3 height) {
    vec2 slope = height.yz, best = height.x + 0.5 * abs(slope.yx);
    vec2 steep = max(abs(slope), 1e-6 * (abs(height.x) + abs(slope.x) + abs(slope.y)));
    vec2 reach = clamp(best / steep, -0.5, 0.5);  // how far it goes down from the middle
    return vec4(mix(vec2(-0.5), -reach, greaterThan(slope, vec2(0.0))), mix(vec2(0.5), reach, lessThan(slope, vec2(0.0))));
}

// Its share: a ramp, integrated twice.
float lightShare(vec3 height) {
    vec2 slope = abs(height.yz);
    float reach = 0.5 * (slope.x + slope.y);
    if (abs(height.x) >= reach) return height.x > 0.0 ? 1.0 : 0.0;
    slope = max(slope, 1e-3 * max(slope.x, slope.y));
    vec4 ramp = max(height.x + 0.5 * vec4(slope.x + slope.y, slope.y - slope.x, slope.x - slope.y, -slope.x - slope.y), 0.0);
    ramp *= ramp;
    return clamp((ramp.x - ramp.y - ramp.z + ramp.w) / (2.0 * slope.x * slope.y), 0.0, 1.0);
}
