// What the checks of distance fields share: shapes whose distance is a formula, the least distance
// over t along a ray in float64, and a slab between light and ground whose shadow is exact.
#pragma once

#include <functional>
#include <random>

#include "core/checks.h"
#include "core/truths.h"
#include "scene/gallery.h"
#include "scene/shapes.h"

namespace penumbra {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec3;
using glm::vec4;
using Rows = std::vector<vec4>;
using SettingList = std::vector<std::string>;

constexpr int kRows = 256;
constexpr glm::ivec2 kSmall{128, 128};

struct Dice {
    std::mt19937 engine;
    explicit Dice(unsigned seed) : engine(seed) {}
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
    dvec3 point(double low, double high) {
        const double x = (*this)(low, high), y = (*this)(low, high);
        return {x, y, (*this)(low, high)};
    }
    dvec3 direction();  // unit
};

// A box with rounded edges: a sphere where halfSize is 0, a box where radius is 0.
struct RoundedBox {
    dvec3 center{0.0}, halfSize{0.0};
    double radius = 0;
    double distance(dvec3 p) const;
};

// The infimum of distance(t) / t over [first, reach], for a distance that is smooth or has one
// kink: dense samples, then a golden section around the least one.
double leastRatio(const std::function<double(double)>& distance, double first, double reach);

// A slab over the ground, thick or thin, turned about the light's axis, its edge under the light's
// centre. The light faces straight down.
//
//              light    H              A receiver right of the edge loses what the slab's upper
//              --+--                   edge hides, one left of it what the lower edge hides: two
//        +-------+      top            polygons in the planes of the slab's faces, exact.
//        |  slab |
//        +-------+      bottom
//     -----------+---------  ground
struct SlabStage {
    static constexpr double kLightHeight = 9, kLightWidth = 1.5, kTop = 4;
    double thickness = 1, turnRadians = 0;

    static Light light();
    Scene scene() const;
    std::vector<dvec3> face(double height) const;  // corners of the slab there
    RoundedBox shape() const;                      // for turnRadians = 0
    double visibility(dvec3 receiver) const;
};

// Receivers on the ground as the camera sees them; elsewhere the mask is 0.
struct GroundPixels {
    GroundPixels(const Scene& scene, glm::ivec2 size);
    template <typename Truth>
    Image image(const Truth& truth) const {
        Image result(mask.width, mask.height, 1);
        for (std::size_t i = 0; i < result.pixels.size(); ++i)
            if (mask.pixels[i] > 0) result.pixels[i] = float(truth(positions[i]));
        return result;
    }
    std::vector<dvec3> positions;
    Image mask;
};

// Root mean square error against rays: 256², as few pixels as tell.
double errorAgainstRays(const std::string& scene, const SettingList& settings = {});

// Root mean square error against the exact share of the light, over receivers on the ground.
double errorUnderSlab(const SlabStage& stage, const SettingList& settings);

}  // namespace penumbra
