// Two pictures of one technique held against each other, pixel by pixel.
#pragma once

#include <glm/glm.hpp>

#include "core/image.h"
#include "truth/ray_tracer.h"

namespace penumbra {

// Rounding's part: a difference that no picture of 8 bits shows.
inline constexpr float kVisible = 1.0f / 256.0f;

struct Difference {
    int any = 0;      // pixels that differ at all
    int visible = 0;  // by more than kVisible
    double sum = 0;   // of what these differ by
    float most = 0;
    glm::ivec2 where{0, 0};  // the pixel of the most

    void count(float off, int x, int y);
};

Difference difference(const Image& a, const Image& b);

// Pixels at (x + by, y + by) of one picture against (x, y) of the other, where both are.
Difference shifted(const Image& a, const Image& b, int by);

double meanDifference(const Image& a, const Image& b);

// Whether the rays' picture changes within two pixels, or the surface within one.
bool nearAnEdge(const Image& truth, const Receivers& receivers, int x, int y);

}  // namespace penumbra
