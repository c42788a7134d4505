// Share of the square [-1/2, 1/2]² where height.x + s height.y + t height.z > 0. Summed over the square, a step becomes a
// ramp along s, and half a square along t: what is left are four squares, one for each corner. Wholly above or below, all
// four nearly cancel, so that comes first; where the line cuts the square, the steeper slope is not small beside height.x,
// and the other may be 0.
float shareAboveHorizon(vec3 height) {
    vec2 slope = abs(height.yz);
    float reach = 0.5 * (slope.x + slope.y);
    if (abs(height.x) >= reach) return height.x > 0.0 ? 1.0 : 0.0;
    slope = max(slope, 1e-3 * max(slope.x, slope.y));
    vec4 ramp = max(height.x + 0.5 * vec4(slope.x + slope.y, slope.y - slope.x, slope.x - slope.y, -slope.x - slope.y), 0.0);
    ramp *= ramp;
    return clamp((ramp.x - ramp.y - ramp.z + ramp.w) / (2.0 * slope.x * slope.y), 0.0, 1.0);
}
