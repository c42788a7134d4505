// What the checks of variance shadow maps share: boxes of a map in float64, two scenes whose depths
// are known, frames that several checks look at.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "core/checks.h"
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

constexpr int kRows = 512;
constexpr glm::ivec2 kSmall{256, 256};
constexpr glm::ivec2 kTiny{64, 64};  // where only images of the light's map are looked at
inline const std::string kRounding = "float32 products and sums of a few terms: 1e-5 relative";

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
};

// One channel of an image of the light's map, as sums over boxes; texels are counted from the lower
// left, as u and v are.
class BoxSums {
public:
    template <typename Value>  // double(float): what is summed of a texel
    BoxSums(const Image& map, int channel, Value value) : width_(map.width), height_(map.height) {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) add(x, y, value(map.at(x, height_ - 1 - y, channel)));
    }
    BoxSums(const Image& map, int channel)
        : BoxSums(map, channel, [](float v) { return double(v); }) {}

    // Over all texels between these corners [texels]; parts of texels count in part.
    double operator()(dvec2 low, dvec2 high) const;
    double largest() const { return largest_; }  // of all sums from the lower left corner

private:
    void add(int x, int y, double value);
    double at(int x, int y) const;  // over texels left of x and below y
    double at(dvec2 corner) const;

    int width_, height_;
    std::vector<double> sums_;
    double largest_ = 0;
};

// Mean and variance of the depths of a box; beyond the border depth is 1.
struct DepthBoxes {
    explicit DepthBoxes(const Image& shadowMap)
        : size(shadowMap.width),
          depths(shadowMap, 0),
          squares(shadowMap, 0, [](float d) { return double(d) * double(d); }) {}
    dvec2 meanVariance(dvec2 centerUv, dvec2 widthUv) const;

    int size;
    BoxSums depths, squares;
};

// Cantelli's inequality: at most this share of a distribution lies at `depth` or beyond.
inline double upperBound(double depth, dvec2 meanVariance) {
    const double beyond = depth - meanVariance.x;
    return beyond <= 0 ? 1 : meanVariance.y / (meanVariance.y + beyond * beyond);
}

// The filter of given/filter.glsl over a receiver whose plane is parallel to the light: the mean of
// what lit(centerUv, widthUv) says of its cells.
template <typename Lit>
double overCells(dvec2 uv, dvec2 widthUv, int cells, Lit lit) {
    double sum = 0;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            sum += lit(uv + ((dvec2(i, j) + 0.5) / double(cells) - 0.5) * widthUv,
                       widthUv / double(cells));
    return sum / (cells * cells);
}

// A light that shines straight down on plates parallel to it: every surface has one depth.
//
//   H = 8   ----====----     light, 1.5 wide
//   h = 4   ____|            x < 0, all z
//   h = 2         ____       z < 0, x between 0.2 and 2
//   0       ------------     ground, through the origin; it rises by `groundSlope` along x
Scene platesScene(float groundSlope = 0.0f);

// What the light's matrix says of its map, in float64.
struct LightView {
    LightView(const Image& lightClipFromWorld, const Light& light);

    // What constant_bias=`texels` is at this depth, in a map of this size.
    double bias(double depth, double texels, int mapSize) const;

    double nearPlane, farPlane;
    dvec2 tangents;  // of the view's width and height
    dvec2 scaleUv;   // S
};
const ImageRequest kMatrix{"light_clip_from_world", {4, 4}};

}  // namespace penumbra
