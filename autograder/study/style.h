// How each curve is drawn, on the page and in the picture alike: a colour for each program, a
// marker and a dash for each of its curves.
#pragma once

#include <string>
#include <vector>

#include "study/results.h"

namespace penumbra {

struct CurveStyle {
    std::string program, curve;
    std::string color;   // of CSS: competitors are var(--ink) and var(--soft), both themes' own
    std::string marker;  // path data around the origin, within a circle of radius 1
    std::string dash;    // of SVG: stroke-dasharray
};

// In the order of the points, those without figures included.
std::vector<CurveStyle> curveStyles(const StudyResults& results);

}  // namespace penumbra
