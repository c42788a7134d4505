#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/report.h"
#include "study/page.h"

namespace penumbra {

namespace {

constexpr double kWidth = 430, kHeight = 330;                       // of a panel
constexpr double kLeft = 52, kRight = 12, kTop = 30, kBottom = 40;  // around its plot
constexpr int kColumns = 2;

// Distinct on white and on black. Twin: page.html.
constexpr const char* kColors[] = {"#4477cc", "#cc6633", "#2e9a6b", "#b0509c",
                                   "#b89400", "#3aa3b8", "#c44d58", "#7a68c8",
                                   "#6c8a2e", "#8a7259", "#5f7f99", "#d08090"};

struct Axis {
    double low, high;  // logarithms
    double start, end;

    static Axis around(double lowest, double highest, double start, double end) {
        const double pad = std::max(0.06 * std::log(highest / lowest), 0.08);
        return {std::log(lowest) - pad, std::log(highest) + pad, start, end};
    }
    double at(double value) const {
        return start + (std::log(value) - low) / (high - low) * (end - start);
    }
    std::vector<double> ticks() const {
        std::vector<double> result;
        for (int decade = -9; decade < 9; ++decade)
            for (const double step : {1.0, 2.0, 5.0}) {
                const double value = step * std::pow(10.0, decade);
                if (std::log(value) < low || std::log(value) > high) continue;
                if (step == 1 || high - low < 5) result.push_back(value);
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

double errorOf(const StudyPoint& p) { return std::max(p.metrics.rmse, 1e-5); }

std::string pathOf(const Points& points, const Axis& x, const Axis& y) {
    std::string path = "M";
    for (const StudyPoint* p : points)
        path += fmt::format("{}{:.1f} {:.1f}", path == "M" ? "" : "L", x.at(p->floors.median),
                            y.at(errorOf(*p)));
    return path;
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg;
    for (const double t : x.ticks())
        svg += fmt::format(
            "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>"
            "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4:g}</text>",
            x.at(t), y.start, y.end, y.start + 15, t);
    for (const double t : y.ticks())
        svg += fmt::format(
            "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>"
            "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>",
            x.start, y.at(t), x.end, x.start - 5, y.at(t) + 4, t);
    return svg;
}

std::string panel(const Points& points, const std::vector<std::string>& curves,
                  const std::string& title) {
    double cheapest = 1e30, dearest = 0, best = 1e30, worst = 0;
    for (const StudyPoint* p : points) {
        cheapest = std::min(cheapest, p->floors.median),
        dearest = std::max(dearest, p->floors.median);
        best = std::min(best, errorOf(*p)), worst = std::max(worst, errorOf(*p));
    }
    const Axis x = Axis::around(cheapest, dearest, kLeft, kWidth - kRight);
    const Axis y = Axis::around(best, worst, kHeight - kBottom, kTop);
    std::string svg = grid(x, y);
    svg += fmt::format("<text class=\"title\" x=\"{}\" y=\"18\">{}</text>", kLeft, escaped(title));
    svg += fmt::format("<path class=\"front\" d=\"{}\"/>", pathOf(frontOf(points), x, y));
    for (std::size_t c = 0; c < curves.size(); ++c) {
        Points own;
        std::copy_if(points.begin(), points.end(), std::back_inserter(own),
                     [&](const StudyPoint* p) { return p->curve == curves[c]; });
        if (own.empty()) continue;
        const char* color = kColors[c % std::size(kColors)];
        svg += fmt::format("<path class=\"curve\" stroke=\"{}\" d=\"{}\"/>", color,
                           pathOf(frontOf(own), x, y));
        for (const StudyPoint* p : own)
            svg += fmt::format(
                "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" "
                "fill=\"{}\"><title>{}</title></circle>",
                x.at(p->floors.median), y.at(errorOf(*p)), color,
                escaped(fmt::format("{}, {}: {:.2f} floors, RMSE {:.4f}", p->curve,
                                    p->settings.empty() ? "defaults" : p->settings,
                                    p->floors.median, p->metrics.rmse)));
    }
    return svg;
}

}  // namespace

std::string studySvg(const StudyResults& results) {
    std::vector<std::string> curves;
    std::vector<std::pair<std::string, Points>> panels;  // title, points
    for (const StudyPoint& p : results.points) {
        if (!p.error.empty()) continue;
        if (std::find(curves.begin(), curves.end(), p.curve) == curves.end())
            curves.push_back(p.curve);
        const std::string title = p.scene + (p.light == "point" ? ", point light" : "");
        auto it = std::find_if(panels.begin(), panels.end(),
                               [&](const auto& entry) { return entry.first == title; });
        if (it == panels.end()) it = panels.insert(panels.end(), {title, {}});
        it->second.push_back(&p);
    }
    std::stable_partition(panels.begin(), panels.end(), [](const auto& entry) {
        return entry.first.find(',') == std::string::npos;
    });
    const int rows = int(panels.size() + kColumns - 1) / kColumns;
    const int legendRows = int(curves.size() + 2) / 3;
    const double height = rows * kHeight + 18 * legendRows + 40;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"system-ui, sans-serif\" font-size=\"11\">\n<style>"
        "rect {{ fill: #fff }} text {{ fill: #65625c }} .title {{ fill: #1d1c1a; font-size: 14px; "
        "font-weight: 600 }} .grid {{ stroke: #e4e1da }} .front {{ fill: none; stroke: #1d1c1a; "
        "stroke-dasharray: 5 4; opacity: .5 }} .curve {{ fill: none; stroke-width: 1.5; opacity: "
        ".6 }}</style>\n<rect width=\"{0}\" height=\"{1}\"/>\n",
        kColumns * kWidth, height);
    for (std::size_t i = 0; i < panels.size(); ++i)
        svg += fmt::format("<g transform=\"translate({} {})\">{}</g>\n",
                           kWidth * double(i % kColumns), kHeight * double(i / kColumns),
                           panel(panels[i].second, curves, panels[i].first));
    const double legend = rows * kHeight + 14;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const double x = kLeft + 270 * double(c % 3), y = legend + 18 * double(c / 3);
        svg += fmt::format(
            "<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/><text x=\"{}\" "
            "y=\"{}\">{}</text>\n",
            x, y - 4, kColors[c % std::size(kColors)], x + 9, y, escaped(curves[c]));
    }
    svg += fmt::format(
        "<text x=\"{}\" y=\"{}\">across: cost in floors; up: RMSE against truth. {}, "
        "{}, {}, {}x{}, medians of {}.</text>\n</svg>\n",
        kLeft, height - 10, results.date, escaped(results.processor), escaped(results.renderer),
        results.size.x, results.size.y, results.repetitions);
    return svg;
}

}  // namespace penumbra
