// study.svg: a row for each scene, soft shadows on the left, hard ones on the right.
#include <fmt/format.h>

#include <algorithm>

#include "core/report.h"
#include "study/page.h"
#include "study/panel.h"

namespace penumbra {

namespace {

constexpr double kWidth = 900;
constexpr double kSoftShare = 0.6;  // of the width: soft shadows have twice the techniques

// A line or more for each program: its name, then marker, dash and name of each curve.
std::string legend(const std::vector<CurveStyle>& styles, double& height) {
    std::string svg, program;
    double x = 0, y = 0;
    constexpr double kNames = 178, kSample = 30;
    for (const CurveStyle& style : styles) {
        const double width = kSample + 6.1 * double(style.curve.size()) + 18;
        if (style.program != program) {
            program = style.program, x = kNames, y += 18;
            svg += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\">{}</text>", 14, y,
                               escaped(program));
        } else if (x + width > kWidth)
            x = kNames, y += 18;
        svg += fmt::format(
            "<g style=\"color: {}\" transform=\"translate({} {})\"><path class=\"curve\" "
            "stroke-dasharray=\"{}\" d=\"M0-4H{}\"/><path class=\"point\" "
            "transform=\"translate({} -4) scale({})\" d=\"{}\"/></g>"
            "<text x=\"{}\" y=\"{}\">{}</text>\n",
            style.color, x, y, style.dash, kSample - 6, (kSample - 6) / 2, kMarkerRadius,
            style.marker, x + kSample, y, escaped(style.curve));
        x += width;
    }
    height = y;
    return svg;
}

constexpr const char* kSheet =
    "svg { --paper: #fff; --ink: #1d1c1a; --soft: #77746d; --grid: #eeece6; --line: #cfcbc1 }"
    "@media (prefers-color-scheme: dark) { svg { --paper: #1b1c20; --ink: #eceae5; --soft: #9a978f;"
    " --grid: #34363c; --line: #45474f } }"
    ".paper { fill: var(--paper) } text { fill: var(--soft) } .title { fill: var(--ink); "
    "font-size: 14px; font-weight: 600 } .name { fill: var(--ink); font-weight: 600 } .label { "
    "fill: currentColor; font-size: 10.5px; font-weight: 600; stroke: var(--paper); "
    "stroke-width: 3px; paint-order: stroke } .grid { stroke: var(--grid) } .decade { stroke: "
    "var(--line) } .noise { stroke: var(--soft); stroke-dasharray: 1 3 } .front { fill: none; "
    "stroke: var(--ink); stroke-width: 6; stroke-linejoin: round; opacity: .2 } .curve { fill: "
    "none; stroke: currentColor; stroke-width: 1.4 } .point { fill: currentColor } .beaten { fill: "
    "var(--paper); stroke: currentColor; stroke-width: .3; opacity: .7 }";

// Points and truth of one scene and light, in the order of the results.
struct Cell {
    std::string scene, light;
    Points points;
};

std::vector<Cell> cellsOf(const StudyResults& results) {
    std::vector<Cell> cells;
    for (const StudyPoint& p : results.points) {
        if (!p.error.empty()) continue;
        auto it = std::find_if(cells.begin(), cells.end(), [&](const Cell& c) {
            return c.scene == p.scene && c.light == p.light;
        });
        if (it == cells.end()) it = cells.insert(cells.end(), {p.scene, p.light, {}});
        it->points.push_back(&p);
    }
    return cells;
}

}  // namespace

std::string studySvg(const StudyResults& results) {
    const std::vector<Cell> cells = cellsOf(results);
    std::vector<std::string> scenes;
    bool soft = false, hard = false;
    for (const Cell& c : cells) {
        (c.light == "point" ? hard : soft) = true;
        if (std::find(scenes.begin(), scenes.end(), c.scene) == scenes.end())
            scenes.push_back(c.scene);
    }
    std::vector<CurveStyle> styles = curveStyles(results);
    std::erase_if(styles, [&](const CurveStyle& s) {
        return std::none_of(results.points.begin(), results.points.end(), [&](const StudyPoint& p) {
            return p.error.empty() && p.program == s.program && p.curve == s.curve;
        });
    });
    const double softWidth = soft ? (hard ? kSoftShare : 1.0) * kWidth : 0;
    double top = 0;
    std::string svg = legend(styles, top);
    svg += fmt::format(
        "<path class=\"front\" d=\"M178 {0}h24\"/><text x=\"208\" y=\"{1}\">under the points that "
        "no other of the scene beats in cost and error</text>\n",
        top + 14, top + 18);
    top += 36;
    for (const Cell& c : cells) {
        const bool left = c.light != "point";
        const auto row = std::find(scenes.begin(), scenes.end(), c.scene) - scenes.begin();
        const auto truth = std::find_if(
            results.truths.begin(), results.truths.end(),
            [&](const StudyTruth& t) { return t.scene == c.scene && t.light == c.light; });
        svg += fmt::format("<g transform=\"translate({} {})\">{}</g>\n", left ? 0 : softWidth,
                           top + kPanelHeight * double(row),
                           drawPanel(c.points, left ? softWidth : kWidth - softWidth, styles,
                                     c.scene + (left ? ", soft shadows" : ", hard shadows"),
                                     truth == results.truths.end() ? nullptr : &*truth));
    }
    const double height = top + kPanelHeight * double(scenes.size()) + 24;
    svg += fmt::format(
        "<text x=\"14\" y=\"{}\">{}, {}, {}, times from {}, {}x{} pixels, medians of "
        "{}</text>\n",
        height - 9, results.date, escaped(results.processor), escaped(results.renderer),
        escaped(results.totalsTimer), results.size.x, results.size.y, results.repetitions);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"system-ui, sans-serif\" font-size=\"11\">\n<style>{2}</style>"
        "\n<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{3}</svg>\n",
        kWidth, height, kSheet, svg);
}

}  // namespace penumbra
