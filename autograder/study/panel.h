// One plot of study.svg: cost against error on one scene under one light, both logarithmic.
#pragma once

#include <string>
#include <vector>

#include "study/results.h"
#include "study/style.h"

namespace penumbra {

constexpr double kPanelHeight = 400;  // pixels
constexpr double kMarkerRadius = 4.2;

using Points = std::vector<const StudyPoint*>;

// SVG from (0,0) to (width,kPanelHeight), in the classes of svg.cpp's sheet. `truth` may be null.
std::string drawPanel(const Points& points, double width, const std::vector<CurveStyle>& styles,
                      const std::string& title, const StudyTruth* truth);

}  // namespace penumbra
