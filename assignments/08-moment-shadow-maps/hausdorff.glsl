#include "hamburger.glsl"

Blockers hausdorffBlockers(vec4 b, float t) {
    vec2 z = otherDepths(b, t);
    if (z.x >= -1.0 && z.y <= 1.0) return hamburgerBlockers(b, t);
    t = clamp(t, -0.9999, 0.9999);
    vec3 u = vec3(1.0 - b.y, b.x - b.z, b.y - b.w);
    float between = u.y - t * u.x;
    float x = clamp((u.z - t * u.y) / (abs(between) < 1e-9 ? 1e-9 : between), -0.9999, 0.9999);
    vec3 p = vec3(t * x, -(t + x), 1.0);
    if (x >= t) return Blockers(clamp(dot(p, vec3(1.0 - b.x, b.x - b.y, b.y - b.z)) / (2.0 * (1.0 + t) * (1.0 + x)), 0.0, 1.0), -1.0);
    float last = dot(p, vec3(1.0 + b.x, b.x + b.y, b.y + b.z)) / (2.0 * (1.0 - t) * (1.0 - x));
    float here = (u.y - x * u.x) / ((1.0 - t * t) * (t - x));
    float share = clamp(1.0 - here - last, 0.0, 1.0);
    return Blockers(share, share > 0.0 ? clamp((b.x - here * t - last) / share, -1.0, t) : 0.0);
}
