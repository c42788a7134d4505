// What the checks of soft shadows from one map share: rows of light views, the program's own map as
// the light's matrix tells it, and scenes whose visibility has a closed form.
#pragma once

#include <cmath>
#include <random>

#include "core/checks.h"
#include "core/truths.h"
#include "scene/gallery.h"
#include "scene/shapes.h"

namespace penumbra {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using Rows = std::vector<vec4>;

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
};

constexpr int kRows = 256;
constexpr glm::ivec2 kSmall{256, 256};
inline const std::string kRounding = "float32 products and sums of a few terms: 1e-5 relative";

// A perspective light view in float64: distances and depths, and what S is in it.
struct LightView {
    double nearPlane, farPlane, tangents, width;

    explicit LightView(Dice& dice)
        : nearPlane(dice(0.5, 5)),
          farPlane(nearPlane * dice(1.5, 6)),
          tangents(dice(0.5, 3)),
          width(dice(0.1, 3)) {}
    double distance(double t) const { return nearPlane + t * (farPlane - nearPlane); }
    double depth(double z) const { return farPlane / (farPlane - nearPlane) * (1 - nearPlane / z); }
    double scaleUv() const { return width * (1 / nearPlane - 1 / farPlane) / tangents; }
    // By similar triangles at the receiver, then seen from the light.
    double penumbraUv(double receiver, double blocker) const {
        return width * (receiver - blocker) / blocker / (receiver * tangents);
    }
};

inline const ImageRequest kMatrix{"light_clip_from_world", {4, 4}};

// What the light's matrix says of the map: S and the bias of README §2, in float64.
struct MapView {
    double nearPlane, farPlane;
    dvec2 tangents, scaleUv;

    MapView(const Image& clipFromWorld, const Light& light) {
        glm::dmat4 m;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                m[column][row] = clipFromWorld.at(column, row);
        const glm::dmat4 p = m * glm::inverse(glm::dmat4(light.viewFromWorld()));
        nearPlane = p[3][2] / (p[2][2] - 1), farPlane = p[3][2] / (p[2][2] + 1);
        tangents = {2 / p[0][0], 2 / p[1][1]};
        scaleUv = double(light.width) * (1 / nearPlane - 1 / farPlane) / tangents;
    }
    // One texel, in depth.
    double bias(double depth, int mapSize) const {
        const double inverse = 1 / nearPlane + depth * (1 / farPlane - 1 / nearPlane);
        return std::max(tangents.x, tangents.y) / mapSize * inverse /
               (1 / nearPlane - 1 / farPlane);
    }
};

// The program's own map, read as its shaders read it.
struct Map {
    const Image& depth;
    // OpenGL's rows run upwards.
    float operator()(vec2 uv) const {
        const int x = int(std::floor(uv.x * float(depth.width)));
        const int y = int(std::floor(uv.y * float(depth.height)));
        if (x < 0 || y < 0 || x >= depth.width || y >= depth.height) return 1.0f;
        return depth.at(x, depth.height - 1 - y);
    }
};

// n x n places around uv, in rows and columns.
template <typename Visit>
void visitGrid(vec2 uv, vec2 width, int n, Visit&& visit) {
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) visit(uv + ((vec2(i, j) + 0.5f) / float(n) - 0.5f) * width);
}

// A plane that nothing blocks: what it sees of the light is what is above its horizon.
void expectHorizonOnly(const Scene& scene, const std::vector<std::string>& settings);

// A wide light, half of it below the ground that it shines along: each receiver sees another share.
Scene settingLight();

// rmse of `halfplane` against its formula, over receivers on the ground.
double halfPlaneError(int searchSamples, int filterSamples, std::vector<std::string> settings = {});

}  // namespace penumbra
