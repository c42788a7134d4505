// Fails: Task5Hausdorff.AtLeastHamburgersShareAndNeverMoreThanTheTrueOne, Task5Hausdorff.ThreeDepthsInsideOrFourWithTheEndsAreExact, Task6WholeShadow.HausdorffIsCloserToRays · two of four points lie at the ends, even where three points inside are right
#include "hamburger.glsl"

Blockers hausdorffBlockers(vec4 b, float t) {
    vec2 others = otherDepths(b, t);
    if (t <= -1.0 || t > 1.0) return hamburgerBlockers(b, t);
    const float tiny = 1e-9;
    vec3 inside = vec3(1.0 - b.y, b.x - b.z, b.y - b.w);  // E[(1 - z²) z^i]
    float x = clamp((inside.z - t * inside.y) / (inside.y - t * inside.x), -1.0, 1.0);
    if (isnan(x)) x = 1.0;
    vec3 p = vec3(t * x, -(t + x), 1.0);  // (z - t) (z - x)
    if (t <= x) {
        float first = dot(p, vec3(1.0 - b.x, b.x - b.y, b.y - b.z)) / max(2.0 * (1.0 + t) * (1.0 + x), tiny);
        return Blockers(clamp(first, 0.0, 1.0), -1.0);
    }
    float last = clamp(dot(p, vec3(1.0 + b.x, b.x + b.y, b.y + b.z)) / max(2.0 * (1.0 - t) * (1.0 - x), tiny), 0.0, 1.0);
    float here = clamp((inside.y - x * inside.x) / max((1.0 - t * t) * (t - x), tiny), 0.0, 1.0);
    float share = clamp(1.0 - here - last, 0.0, 1.0);
    return Blockers(share, share > 0.0 ? clamp((b.x - here * t - last) / share, -1.0, t) : 0.0);
}
