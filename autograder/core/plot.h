// A plot as one SVG file: lines over a common x, in one panel or several below each other. Light
// ground, names beside the lines, no script and no font to load.
//
//   Curve curve{.name = "bias", .title = "Too little bias, too much",
//               .x = {"constant bias [texels]"},
//               .panels = {{{"acne [% of the plane]"}, {{"45°", points}}}},
//               .marks = {{0.5, "½ tan 45°"}}};
//   writeText("bias.svg", curveSvg(curve));
//
// What cannot be drawn is shown as what it is: NaN and infinities as a cross on the top edge,
// values that a logarithm has no place for (0 and below) as a hollow triangle on the bottom edge.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace penumbra {

struct PlotAxis {
    std::string label;  // with its unit
    bool log = false;
    std::vector<double> ticks = {};  // empty: decades, or steps of 1, 2 or 5
};

struct PlotSeries {
    std::string name;                     // empty: none is written
    std::vector<glm::dvec2> points = {};  // by growing x
    bool formula = false;                 // not measured: grey, dashed, without markers
};

struct PlotPanel {
    PlotAxis y;
    std::vector<PlotSeries> series;
};

struct PlotMark {  // a vertical line through all panels
    double x;
    std::string label;
};

struct Curve {
    std::string name = "";  // the file's: letters, digits, hyphens
    std::string title;
    std::string says;  // one sentence: what it teaches
    PlotAxis x;
    std::vector<PlotPanel> panels = {};
    std::vector<PlotMark> marks = {};
};

std::string curveSvg(const Curve& curve);

}  // namespace penumbra
