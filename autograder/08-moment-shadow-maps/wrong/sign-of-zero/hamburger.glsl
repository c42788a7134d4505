// Fails: Task3Hamburger.TheOtherDepthsCompleteThreePoints · sign(0) is 0: no roots with t half-way between them
#include "moment_shadow.glsl"

// What is left of z and z² when lower powers have told all they can: q1 = z - E[z], q2 = z² - E[z²] - slope q1.
// Their product has mean 0.
struct Regression {
    float mean, square, slope;  // E[z], E[z²], cov(z, z²) / var(z)
    float linear, quadratic;    // variances of q1 and q2
};

// Variances of a single plane without bias are 0 but for rounding.
Regression regression(vec4 b) {
    float variance = max(b.y - b.x * b.x, 1e-12), covariance = b.z - b.x * b.y;
    float slope = covariance / variance;
    return Regression(b.x, b.y, slope, variance, max(b.w - b.y * b.y - slope * covariance, 1e-12));
}

vec2 remainders(Regression r, float z) {
    float q1 = z - r.mean;
    return vec2(q1, z * z - r.square - r.slope * q1);
}

// All terms are positive: nothing cancels.
float weightAt(Regression r, float z) {
    vec2 q = remainders(r, z);
    return 1.0 / (1.0 + q.x * q.x / r.linear + q.y * q.y / r.quadratic);
}

// A fraction that stays finite.
float limited(float above, float below) {
    const float limit = 1e6;
    if (abs(above) < limit * abs(below)) return above / below;
    return (above < 0.0) == (below < 0.0) ? limit : -limit;
}

// Roots of a z² + b z + c, one by the usual formula, without a difference, and the other by their product c / a.
vec2 otherRoots(Regression r, float t) {
    vec2 q = remainders(r, t) / vec2(r.linear, r.quadratic);
    float a = q.y, b = q.x - r.slope * a, c = 1.0 - r.mean * b - r.square * a;
    float root = sqrt(max(b * b - 4.0 * a * c, 0.0)), sum = -0.5 * (b + sign(b) * root);
    vec2 roots = vec2(limited(sum, a), limited(c, sum));
    return vec2(min(roots.x, roots.y), max(roots.x, roots.y));
}

vec2 otherDepths(vec4 b, float t) { return otherRoots(regression(b), t); }

Blockers hamburgerBlockers(vec4 b, float t) {
    Regression r = regression(b);
    vec2 others = otherRoots(r, t);
    if (t <= others.x) return Blockers(0.0, 0.0);
    if (t <= others.y) return Blockers(weightAt(r, others.x), clamp(others.x, -1.0, t));
    float here = weightAt(r, t), share = 1.0 - here;
    return Blockers(share, share > 0.0 ? clamp((b.x - here * t) / share, -1.0, t) : 0.0);
}
