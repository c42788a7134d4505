// study.svg: a row for each scene, soft shadows on the left, hard ones on the right.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/report.h"
#include "study/page.h"
#include "study/style.h"

namespace penumbra {

namespace {

constexpr double kWidth = 900, kRowHeight = 400;
constexpr double kSoftShare = 0.6;  // of the width: soft shadows have twice the techniques
constexpr double kLeft = 46, kRight = 12, kTop = 30, kBottom = 40;  // around a panel's plot
constexpr double kMarker = 4.2;                                     // radius
constexpr double kLetter = 6.7;  // mean width of one at the labels' 10.5 pixels

struct Rectangle {
    double left, top, right, bottom;

    bool meets(const Rectangle& o) const {
        return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
    }
};

// Logarithmic. Values of 0 stand at `zero`, below all others, where there are any.
struct Axis {
    double low = 0, high = 0;  // logarithms
    double zero = 0;
    double start, end;

    Axis(const std::vector<double>& values, double start, double end) : start(start), end(end) {
        double least = 1e30, most = 0;
        for (const double v : values)
            if (v > 0) least = std::min(least, v), most = std::max(most, v);
        if (most == 0) least = most = 1;
        if (std::count(values.begin(), values.end(), 0.0)) zero = least = 0.5 * least;
        const double pad = std::max(0.05 * std::log(most / least), 0.08);
        low = std::log(least) - pad, high = std::log(most) + pad;
    }
    double at(double value) const {
        return start + (std::log(value > 0 ? value : zero) - low) / (high - low) * (end - start);
    }
    bool holds(double value) const {
        return value > zero && std::log(value) > low && std::log(value) < high;
    }
    // Decades; 2 and 5 times them where there is room; more steps where there are few decades.
    std::vector<double> ticks() const {
        const double range = high - low;
        std::vector<double> result;
        for (int decade = -9; decade < 9; ++decade)
            for (const int step : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
                const double value = step * std::pow(10.0, decade);
                const bool wanted = step == 1 || (range < 6 && (step == 2 || step == 5)) ||
                                    (range < 1.8 && step < 9);
                if (wanted && holds(value)) result.push_back(value);
            }
        return result;
    }
};

using Points = std::vector<const StudyPoint*>;

// Those that none of the others beats on both axes, by growing cost.
Points frontOf(Points points) {
    std::sort(points.begin(), points.end(), [](const StudyPoint* a, const StudyPoint* b) {
        return a->floors.median < b->floors.median;
    });
    Points front;
    for (const StudyPoint* p : points)
        if (front.empty() || p->metrics.rmse < front.back()->metrics.rmse) front.push_back(p);
    return front;
}

bool isDecade(double value) { return std::abs(std::remainder(std::log10(value), 1.0)) < 1e-9; }

class Panel {
public:
    Panel(Points points, double width, const std::vector<CurveStyle>& styles)
        : points_(std::move(points)),
          width_(width),
          styles_(styles),
          x_(each([](const StudyPoint& p) { return p.floors.median; }), kLeft, width - kRight),
          y_(each([](const StudyPoint& p) { return p.metrics.rmse; }), kRowHeight - kBottom, kTop) {
    }

    std::string draw(const std::string& title, const StudyTruth* truth) {
        std::string svg = grid();
        svg +=
            fmt::format("<text class=\"title\" x=\"{}\" y=\"18\">{}</text>", kLeft, escaped(title));
        if (truth && y_.holds(truth->standardError))
            svg += fmt::format(
                "<path class=\"noise\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>"
                "<text x=\"{2:.1f}\" y=\"{3:.1f}\" text-anchor=\"end\">truth's own "
                "standard error</text>",
                x_.start, y_.at(truth->standardError), x_.end, y_.at(truth->standardError) - 3);
        svg += fmt::format("<path class=\"front\" d=\"{}\"/>", path(frontOf(points_)));
        for (const CurveStyle& style : styles_) svg += curve(style);
        return svg + labels();
    }

private:
    template <typename Value>
    std::vector<double> each(Value&& value) const {
        std::vector<double> values;
        for (const StudyPoint* p : points_) values.push_back(value(*p));
        return values;
    }

    double px(const StudyPoint& p) const { return x_.at(p.floors.median); }
    double py(const StudyPoint& p) const { return y_.at(p.metrics.rmse); }

    std::string path(const Points& points) const {
        std::string path = "M";
        for (const StudyPoint* p : points)
            path += fmt::format("{}{:.1f} {:.1f}", path == "M" ? "" : "L", px(*p), py(*p));
        return path;
    }

    std::string grid() const {
        std::string svg;
        const auto kind = [](double t) { return isDecade(t) ? "decade" : "grid"; };
        for (const double t : x_.ticks())
            svg += fmt::format(
                "<path class=\"{5}\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>"
                "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4:g}</text>",
                x_.at(t), y_.start, y_.end, y_.start + 14, t, kind(t));
        for (const double t : y_.ticks())
            svg += fmt::format(
                "<path class=\"{5}\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>"
                "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{6:g}</text>",
                x_.start, y_.at(t), x_.end, x_.start - 5, y_.at(t) + 4, kind(t), t);
        if (y_.zero > 0)
            svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">0</text>",
                               x_.start - 5, y_.at(0) + 4);
        return svg + fmt::format(
                         "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"end\">cost in floors"
                         "</text><text x=\"{:.1f}\" y=\"18\" text-anchor=\"end\">RMSE, up"
                         "</text>",
                         x_.end, kRowHeight - 10, x_.end);
    }

    Points pointsOf(const CurveStyle& style) const {
        Points own;
        std::copy_if(points_.begin(), points_.end(), std::back_inserter(own),
                     [&](const StudyPoint* p) {
                         return p->curve == style.curve && p->program == style.program;
                     });
        return own;
    }

    std::string curve(const CurveStyle& style) const {
        const Points own = pointsOf(style), front = frontOf(own);
        if (own.empty()) return "";
        std::string svg = fmt::format(
            "<g style=\"color: {}\"><path class=\"curve\" stroke-dasharray=\"{}\" d=\"{}\"/>",
            style.color, style.dash, path(front));
        for (const StudyPoint* p : own)
            svg += fmt::format(
                "<path class=\"{}\" transform=\"translate({:.1f} {:.1f}) scale({})\" d=\"{}\">"
                "<title>{}</title></path>",
                std::count(front.begin(), front.end(), p) ? "point" : "beaten", px(*p), py(*p),
                kMarker, style.marker,
                escaped(fmt::format("{}: {}, {}: {:.2f} floors, RMSE {:.4f}", p->program, p->curve,
                                    p->settings.empty() ? "defaults" : p->settings,
                                    p->floors.median, p->metrics.rmse)));
        return svg + "</g>";
    }

    // The name of each curve that reaches the scene's front, where it covers no point or name.
    std::string labels() const {
        std::vector<Rectangle> taken;
        for (const StudyPoint* p : points_)
            taken.push_back(
                {px(*p) - kMarker, py(*p) - kMarker, px(*p) + kMarker, py(*p) + kMarker});
        std::string svg;
        for (const CurveStyle& style : styles_)
            for (const StudyPoint* p : pointsOf(style)) {
                if (!p->front) continue;
                if (const auto at = place(*p, kLetter * double(style.curve.size()), taken)) {
                    taken.push_back(*at);
                    svg += fmt::format(
                        "<text class=\"label\" style=\"color: {}\" x=\"{:.1f}\" y=\"{:.1f}\">{}"
                        "</text>",
                        style.color, at->left, at->bottom - 3, escaped(style.curve));
                    break;
                }
            }
        return svg;
    }

    // Right of the point, left of it, above or below.
    std::optional<Rectangle> place(const StudyPoint& p, double width,
                                   const std::vector<Rectangle>& taken) const {
        constexpr double kHeight = 12, kGap = kMarker + 3;
        const double x = px(p), y = py(p);
        for (const glm::dvec2 corner : {glm::dvec2(x + kGap, y - kHeight / 2),
                                        {x - kGap - width, y - kHeight / 2},
                                        {x + 2, y - kGap - kHeight},
                                        {x - 2 - width, y + kGap},
                                        {x + 2, y + kGap},
                                        {x - 2 - width, y - kGap - kHeight}}) {
            const Rectangle r{corner.x, corner.y, corner.x + width, corner.y + kHeight};
            const bool inside = r.left > kLeft && r.right < width_ - kRight && r.top > kTop &&
                                r.bottom < kRowHeight - kBottom;
            if (inside && std::none_of(taken.begin(), taken.end(),
                                       [&](const Rectangle& o) { return r.meets(o); }))
                return r;
        }
        return std::nullopt;
    }

    Points points_;
    double width_;
    const std::vector<CurveStyle>& styles_;
    Axis x_, y_;
};

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
            style.color, x, y, style.dash, kSample - 6, (kSample - 6) / 2, kMarker, style.marker,
            x + kSample, y, escaped(style.curve));
        x += width;
    }
    height = y;
    return svg;
}

constexpr const char* kSheet =
    "svg { --paper: #fff; --ink: #1d1c1a; --soft: #77746d; --grid: #eeece6; --line: #cfcbc1 }"
    "@media (prefers-color-scheme: dark) { svg { --paper: #1b1c20; --ink: #eceae5; --soft: #9a978f;"
    " --grid: #292b30; --line: #45474f } }"
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
        "no "
        "other of the scene beats in cost and error</text>\n",
        top + 14, top + 18);
    top += 36;
    for (const Cell& c : cells) {
        const bool left = c.light != "point";
        const auto row = std::find(scenes.begin(), scenes.end(), c.scene) - scenes.begin();
        const auto truth = std::find_if(
            results.truths.begin(), results.truths.end(),
            [&](const StudyTruth& t) { return t.scene == c.scene && t.light == c.light; });
        svg += fmt::format("<g transform=\"translate({} {})\">{}</g>\n", left ? 0 : softWidth,
                           top + kRowHeight * double(row),
                           Panel(c.points, left ? softWidth : kWidth - softWidth, styles)
                               .draw(c.scene + (left ? ", soft shadows" : ", hard shadows"),
                                     truth == results.truths.end() ? nullptr : &*truth));
    }
    const double height = top + kRowHeight * double(scenes.size()) + 24;
    svg += fmt::format(
        "<text x=\"14\" y=\"{}\">{}, {}, {}, times from {}, {}x{} pixels, medians of "
        "{}</text>\n",
        height - 9, results.date, escaped(results.processor), escaped(results.renderer),
        escaped(results.timer), results.size.x, results.size.y, results.repetitions);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"system-ui, sans-serif\" font-size=\"11\">\n<style>{2}</style>"
        "\n<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{3}</svg>\n",
        kWidth, height, kSheet, svg);
}

}  // namespace penumbra
