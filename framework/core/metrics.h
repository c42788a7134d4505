// How far one visibility image is from another: the figures that viewer, grader and study print.
//
//   Metrics m = compareVisibility(mine, truth);
//   fmt::print("rmse {:.4f}, light leak {:.1f} %\n", m.rmse, 100 * m.lightLeakRate);
#pragma once

#include <cstddef>

#include "core/image.h"

namespace penumbra {

struct Metrics {
    std::size_t count = 0;  // pixels compared
    double rmse = 0.0;
    double meanAbsolute = 0.0;  // for hard shadows: the share of mismatching pixels
    double percentile99 = 0.0;  // of the absolute difference
    double maximum = 0.0;
    double penumbraRmse = 0.0;     // over pixels with 0.02 <= truth <= 0.98
    double falseShadowRate = 0.0;  // share of truth > 0.98 that got < 0.9
    double lightLeakRate = 0.0;    // share of truth < 0.02 that got > 0.1
};

// Both images have one channel and the same size. `mask`, if given, has one channel: pixels where
// it is 0 are left out. Every compared value must be finite.
Metrics compareVisibility(const Image& mine, const Image& truth, const Image* mask = nullptr);

}  // namespace penumbra
