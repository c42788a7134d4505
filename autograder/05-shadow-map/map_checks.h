// What the checks of shadow maps share: rows of inputs, the light's view as its matrix tells it,
// and scenes.
#pragma once

#include <cmath>
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

// --- Inputs and truths of single functions ---

struct Dice {
    std::mt19937 engine;
    double operator()(double low, double high) {
        return low + (high - low) * double(engine()) / 4294967295.0;
    }
};

constexpr int kRows = 256;
inline const std::string kRounding = "float32 products and sums of a few terms: 1e-5 relative";

Rows makeRows(int count, const std::function<dvec4()>& row);

// --- Frames and their truth ---

inline const ImageRequest kMatrix{"light_clip_from_world", {4, 4}};
constexpr glm::ivec2 kSmall{256, 256};

glm::dmat4 matrixFrom(const Image& image);

// 1 where the map can be held to the rays pixel by pixel: farther than `texels` from a shadow's
// edge.
Image interior(const TracedScene& truth, const Image& lightClipFromWorld, int mapSize,
               float texels);

// The light stands low over the ground's middle and shines along it: half of the ground is behind
// it.
Scene lowLight();

// A wall without thickness stands on the ground: the one blocker that no bias may jump over.
Scene thinWall();

}  // namespace penumbra
