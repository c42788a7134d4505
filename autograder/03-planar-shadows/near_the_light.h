// What shadow matrix and ray form are compared on: casters that near the height of their light.
#pragma once

#include "planar_checks.h"

namespace penumbra {

// Casters at gaps below the light, in its height, up to 3 beside it.
struct NearTheLight {
    int perGap;
    Rows planes, lights, casters;

    NearTheLight(const std::vector<double>& gaps, int perGap) : perGap(perGap) {
        for (const double gap : gaps) {
            Dice dice{std::mt19937(55)};
            for (int i = 0; i < perGap; ++i) add(dice, gap);
        }
    }
    void add(Dice& dice, double gap) {
        const dvec4 plane(vec4(vec3(dice.direction()), float(dice(-3, 3))));
        const dvec3 n(plane);
        const auto beside = [&](double distance) {
            return distance * glm::normalize(glm::cross(n, dice.direction()));
        };
        const double height = dice(2, 9);
        const dvec3 light(vec3((height - plane.w) * n + beside(dice(0, 3))));
        planes.emplace_back(plane), lights.emplace_back(light, 1);
        casters.emplace_back(light - gap * height * n + beside(dice(0.5, 3)), 1);
    }
    // By gap: largest and root mean square of |p - exact p| over the length of the ray.
    std::vector<dvec2> errors(const char* expression) const {
        const Rows rows = evaluate({.chunk = "ray_form.glsl",
                                    .expression = expression,
                                    .inputs = {{"a", planes}, {"b", lights}, {"c", casters}}});
        std::vector<dvec2> result(rows.size() / std::size_t(perGap), dvec2(0));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            dvec2& of = result[i / std::size_t(perGap)];
            const dvec4 exact = flattened(planes[i], lights[i], vec3(casters[i]));
            const dvec3 p = dvec3(exact) / exact.w, mine = dvec3(vec3(rows[i])) / double(rows[i].w);
            const double e = glm::distance(mine, p) / glm::distance(dvec3(vec3(lights[i])), p);
            if (!(e <= of.x)) of.x = e;  // NaN, too
            of.y += e * e;
        }
        for (dvec2& of : result) of.y = std::sqrt(of.y / perGap);
        return result;
    }
};

// The shadow matrix of plane a and light b times caster c, as an expression.
inline constexpr const char* kMatrixForm = "(dot(a, b) * mat4(1.0) - outerProduct(b, a)) * c";

}  // namespace penumbra
