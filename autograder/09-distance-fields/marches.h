// Marches through a formula's distance, and spheres whose least distance / t is known.
#pragma once

#include <cmath>

#include "field_checks.h"

namespace penumbra {

// Where all marches here start; most go along an oblique direction.
inline const dvec3 kOrigin{1, -2, 3}, kOblique{0.48, 0.6, 0.64};

struct March {
    RoundedBox shape;
    dvec3 direction = kOblique;  // z >= 0
    double first = 0, reach = 0, highest = 0, lowest = 0, stepCap = 0, smallest = 0;
    int maxSteps = 0;
};

// (ratio, t, look-ups) of each.
inline Rows marched(const std::vector<March>& marches) {
    Rows a, b, c, d;
    for (const March& m : marches) {
        a.emplace_back(dvec4(m.shape.center, m.shape.radius));
        b.emplace_back(dvec4(m.shape.halfSize, m.stepCap));
        c.emplace_back(dvec4(m.first, m.reach, m.highest, m.lowest));
        d.emplace_back(dvec4(m.smallest, m.maxSteps, m.direction.x, m.direction.y));
    }
    const std::string call =
        "marchRoundedBox(a.xyz, b.xyz, a.w, vec3(1.0, -2.0, 3.0), vec3(d.zw, sqrt(max(1.0 - "
        "dot(d.zw, d.zw), 0.0))), c.x, c.y, Limits(c.z, c.w, b.w, d.x, int(d.y)))";
    return evaluate(
        {.chunk = "analytic_march.glsl",
         .expression = "vec4(" + call + ".ratio, " + call + ".t, " + call + ".steps, 0.0)",
         .inputs = {{"a", a}, {"b", b}, {"c", c}, {"d", d}}});
}

// T7: min over t of (|o + t u - c| - r) / t = sin(atan2(h, b) - asin(r / D)) for a sphere whose
// centre lies b along the ray and h aside, D away.
struct SphereMarches {
    std::vector<March> marches;
    Rows truth;

    SphereMarches(unsigned seed, const std::vector<double>& stepCaps) {
        Dice dice(seed);
        const dvec3 aside = glm::normalize(glm::cross(kOblique, dvec3(0, 0, 1)));
        for (int i = 0; i < kRows; ++i) {
            const double b = dice(1, 6), radius = dice(0.1, 1.5), h = radius + dice(0.02, 0.5);
            const double away = std::hypot(b, h), square = b * b + h * h - radius * radius;
            if (square < 0.25) {  // starts too near: the least ratio is at the ray's start
                --i;
                continue;
            }
            marches.push_back({.shape = {kOrigin + b * kOblique + h * aside, dvec3(0), radius},
                               .first = 0.01,
                               .reach = b + dice(1, 4),
                               .highest = 0.9,
                               .lowest = -0.9,
                               .stepCap = stepCaps[std::size_t(i) % stepCaps.size()],
                               .smallest = 1e-4,
                               .maxSteps = 4000});
            truth.emplace_back(std::sin(std::atan2(h, b) - std::asin(radius / away)));
        }
    }
};

}  // namespace penumbra
