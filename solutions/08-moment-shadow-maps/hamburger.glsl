#include "moment_shadow.glsl"

// z and z² without what the lower powers tell of them: orthogonal polynomials q1 = z - mean, q2 = z² - E[z²] - slope q1.
struct Regression {
    float mean, square, slope;  // E[z], E[z²], cov(z, z²) / var(z)
    float linear, quadratic;    // variances of q1 and q2
};

Regression regression(vec4 b) {
    float variance = max(b.y - b.x * b.x, 1e-12), covariance = b.z - b.x * b.y;
    float slope = covariance / variance;
    return Regression(b.x, b.y, slope, variance, max(b.w - b.y * b.y - slope * covariance, 1e-12));
}

vec2 orthogonal(Regression r, float z) {
    float q1 = z - r.mean;
    return vec2(q1, z * z - r.square - r.slope * q1);
}

float weightAt(Regression r, float z) {
    vec2 q = orthogonal(r, z);
    return 1.0 / (1.0 + q.x * q.x / r.linear + q.y * q.y / r.quadratic);
}

vec2 otherRoots(Regression r, float t) {
    vec2 q = orthogonal(r, t) / vec2(r.linear, r.quadratic);
    float a = q.y, b = q.x - r.slope * a, c = 1.0 - r.mean * b - r.square * a;
    float root = sqrt(max(b * b - 4.0 * a * c, 0.0));
    float half_ = -0.5 * (b < 0.0 ? b - root : b + root);
    float limit = 1e6;
    float far = abs(half_) < limit * abs(a) ? half_ / a : (half_ < 0.0) == (a < 0.0) ? limit : -limit;
    float near = abs(c) < limit * abs(half_) ? c / half_ : limit;
    return vec2(min(far, near), max(far, near));
}

vec2 otherDepths(vec4 b, float t) { return otherRoots(regression(b), t); }

Blockers hamburgerBlockers(vec4 b, float t) {
    Regression r = regression(b);
    vec2 z = otherRoots(r, t);
    if (t <= z.x) return Blockers(0.0, 0.0);
    if (t <= z.y) return Blockers(weightAt(r, z.x), clamp(z.x, -1.0, t));
    float weight = weightAt(r, t);
    float share = 1.0 - weight;
    return Blockers(share, share > 0.0 ? clamp((b.x - weight * t) / share, -1.0, t) : 0.0);
}
