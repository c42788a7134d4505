#include "core/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/report.h"

namespace penumbra {

namespace {

constexpr double kWidth = 700, kPanel = 230;  // a panel's height, without the room around it
constexpr double kLeft = 72, kTop = 44, kGap = 34, kBottom = 50;
constexpr double kLine = 15;     // between lines of text
constexpr double kLetter = 7.7;  // a bold letter of 12 px, rather too wide than too narrow
constexpr const char* kTextColor = "#3c3a36";

// Okabe and Ito's colours, told apart without red or green; each with a marker of its own.
constexpr const char* kColors[] = {"#0072b2", "#d55e00", "#009e73",
                                   "#b0498a", "#8a6d00", "#3a3a3a"};

const char* colorOf(const PlotPanel& panel, std::size_t index) {
    return panel.series[index].formula ? "#77736b" : kColors[index % std::size(kColors)];
}

std::size_t letters(const std::string& utf8) {
    return std::size_t(std::count_if(utf8.begin(), utf8.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

struct Scale {
    bool log;
    double low, high;   // of the axis, logarithms where `log`
    double start, end;  // pixels

    double value(double v) const { return log ? std::log10(v) : v; }
    bool has(double v) const { return std::isfinite(v) && (!log || v > 0); }
    double at(double v) const { return start + (value(v) - low) / (high - low) * (end - start); }
};

// 10⁻⁶ and other decades; anything else as a person writes it.
std::string tickText(double value, bool log) {
    static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const double exponent = std::log10(std::abs(value));
    if (!log || std::abs(exponent - std::round(exponent)) > 1e-9 || std::abs(exponent) < 2.5)
        return fmt::format("{:g}", value);
    std::string text = "10";
    if (exponent < 0) text += "⁻";
    for (const char c : fmt::format("{}", std::abs(std::lround(exponent)))) text += digits[c - '0'];
    return text;
}

std::vector<double> ticksOf(const PlotAxis& axis, const Scale& scale) {
    if (!axis.ticks.empty()) return axis.ticks;
    std::vector<double> ticks;
    if (scale.log) {
        const double decades = scale.high - scale.low;
        const int stride = std::max(1, int(decades / 8));
        for (int d = int(std::floor(scale.low)); d <= int(std::ceil(scale.high)); ++d)
            for (const double step : {1.0, 2.0, 5.0})
                if ((step == 1 && d % stride == 0) || decades < 1.5)
                    ticks.push_back(step * std::pow(10.0, d));
    } else {
        const double wide = (scale.high - scale.low) / 4;
        const double decade = std::pow(10.0, std::floor(std::log10(wide)));
        const double step = decade * (wide >= 5 * decade ? 5 : wide >= 2 * decade ? 2 : 1);
        for (double t = std::ceil(scale.low / step) * step; t <= scale.high; t += step)
            ticks.push_back(std::abs(t) < 1e-9 * step ? 0 : t);
    }
    std::erase_if(ticks, [&](double t) {
        const double slack = 1e-9 * (scale.high - scale.low);
        return scale.value(t) < scale.low - slack || scale.value(t) > scale.high + slack;
    });
    return ticks;
}

// Around all values that have a place on it.
Scale scaleOf(const PlotAxis& axis, const std::vector<double>& values, double start, double end) {
    Scale scale{axis.log, std::numeric_limits<double>::infinity(),
                -std::numeric_limits<double>::infinity(), start, end};
    for (const double v : values)
        if (scale.has(v)) {
            scale.low = std::min(scale.low, scale.value(v));
            scale.high = std::max(scale.high, scale.value(v));
        }
    if (scale.low > scale.high) scale.low = 0, scale.high = 1;  // nothing to place
    const double pad = std::max(0.04 * (scale.high - scale.low), axis.log ? 0.05 : 1e-12);
    scale.low -= pad, scale.high += pad;
    return scale;
}

std::string text(double x, double y, const char* anchor, const std::string& content,
                 const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                       anchor, more.empty() ? "" : " " + more, escaped(content));
}

std::string line(double x0, double y0, double x1, double y1, const char* style) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x0, y0, x1, y1, style);
}

std::string marker(std::size_t kind, double x, double y, const char* color) {
    const auto shape = [&](const char* path) {
        return fmt::format("<path transform=\"translate({:.1f} {:.1f})\" d=\"{}\" fill=\"{}\"/>\n",
                           x, y, path, color);
    };
    switch (kind % 5) {
        case 0:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x,
                               y, color);
        case 1:
            return shape("M-3.2-3.2h6.4v6.4h-6.4z");
        case 2:
            return shape("M0-4.4L4.2 3.2H-4.2z");
        case 3:
            return shape("M0-4.8L4.8 0 0 4.8-4.8 0z");
        default:
            return shape("M0 4.4L-4.2-3.2H4.2z");
    }
}

// A point without a place: why it has none can be seen.
std::string misfit(double x, double y, double value, const Scale& scale, const char* color) {
    if (!std::isfinite(value))
        return fmt::format(
            "<path d=\"M{0:.1f} {1:.1f}l8 8m0-8l-8 8\" stroke=\"{2}\" stroke-width=\"2\" "
            "fill=\"none\"><title>{3}</title></path>\n",
            x - 4, scale.end - 4, color, std::isnan(value) ? "NaN" : "infinite");
    return fmt::format(
        "<path d=\"M{:.1f} {:.1f}h7l-3.5 6.5z\" stroke=\"{}\" stroke-width=\"1.5\" "
        "fill=\"#fff\"><title>{:g}</title></path>\n",
        x - 3.5, y - 7, color, value);
}

std::string seriesSvg(const PlotPanel& panel, std::size_t index, const Scale& x, const Scale& y) {
    const PlotSeries& series = panel.series[index];
    const char* color = colorOf(panel, index);
    std::string path, points;
    bool pen = false;
    for (const glm::dvec2& p : series.points) {
        EXPECTS(x.has(p.x));
        const bool drawn = y.has(p.y);
        if (drawn) path += fmt::format("{}{:.1f} {:.1f}", pen ? "L" : "M", x.at(p.x), y.at(p.y));
        if (!drawn)
            points += misfit(x.at(p.x), y.start, p.y, y, color);
        else if (!series.formula)
            points += marker(index, x.at(p.x), y.at(p.y), color);
        pen = drawn;
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
                       path.empty() ? "M0 0" : path, color, series.formula ? 1.5 : 2,
                       series.formula ? " stroke-dasharray=\"6 4\"" : "") +
           points;
}

// Names right of the lines' ends, pushed apart where they would overlap.
std::string namesSvg(const PlotPanel& panel, const Scale& y, double right) {
    struct Name {
        double y;
        std::size_t index;
    };
    std::vector<Name> names;
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
        EXPECTS(!panel.series[i].points.empty());
        if (panel.series[i].name.empty()) continue;
        const double last = panel.series[i].points.back().y;
        names.push_back({y.has(last) ? y.at(last) : std::isfinite(last) ? y.start : y.end, i});
    }
    std::stable_sort(names.begin(), names.end(),
                     [](const Name& a, const Name& b) { return a.y < b.y; });
    for (std::size_t i = 1; i < names.size(); ++i)
        names[i].y = std::max(names[i].y, names[i - 1].y + kLine);
    double limit = y.start;
    for (std::size_t i = names.size(); i-- > 0; limit -= kLine)
        names[i].y = std::min(names[i].y, limit);
    std::string svg;
    for (const Name& n : names)
        svg += text(right + 10, n.y + 4, "start", panel.series[n.index].name,
                    fmt::format("fill=\"{}\" font-weight=\"600\"", colorOf(panel, n.index)));
    return svg;
}

std::string panelSvg(const PlotPanel& panel, const PlotAxis& xAxis, const Scale& x, double top,
                     const std::vector<PlotMark>& marks) {
    std::vector<double> values = panel.y.ticks;
    for (const PlotSeries& s : panel.series)
        for (const glm::dvec2& p : s.points) values.push_back(p.y);
    const Scale y = scaleOf(panel.y, values, top + kPanel, top);
    std::string svg;
    for (const double t : ticksOf(xAxis, x)) {
        svg += line(x.at(t), y.start, x.at(t), y.end, "stroke=\"#e7e4dd\"");
        svg += text(x.at(t), y.start + 16, "middle", tickText(t, x.log));
    }
    for (const double t : ticksOf(panel.y, y)) {
        svg += line(x.start, y.at(t), x.end, y.at(t), "stroke=\"#e7e4dd\"");
        svg += text(x.start - 7, y.at(t) + 4, "end", tickText(t, y.log));
    }
    svg += line(x.start, y.start, x.end, y.start, "stroke=\"#8a867e\"");
    svg += text(x.start, top - 7, "start", panel.y.label, "font-weight=\"600\"");
    for (const PlotMark& m : marks)
        svg += line(x.at(m.x), y.start, x.at(m.x), y.end,
                    "stroke=\"#3c3a36\" stroke-dasharray=\"2 3\"");
    for (std::size_t i = 0; i < panel.series.size(); ++i) svg += seriesSvg(panel, i, x, y);
    return svg + namesSvg(panel, y, x.end);
}

// Beside their lines, at the foot of the first panel's head: each a line lower than the one before.
std::string marksSvg(const std::vector<PlotMark>& marks, const Scale& x, double top) {
    std::string svg;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const double wide = kLetter * double(letters(marks[i].label));
        const bool left = x.at(marks[i].x) + wide > x.end;
        svg += text(x.at(marks[i].x) + (left ? -5 : 5), top + 13 + kLine * double(i),
                    left ? "end" : "start", marks[i].label);
    }
    return svg;
}

}  // namespace

std::string curveSvg(const Curve& curve) {
    std::size_t longest = 0;
    std::vector<double> xs = curve.x.ticks;
    for (const PlotMark& m : curve.marks) xs.push_back(m.x);
    for (const PlotPanel& panel : curve.panels)
        for (const PlotSeries& s : panel.series) {
            longest = std::max(longest, letters(s.name));
            for (const glm::dvec2& p : s.points) xs.push_back(p.x);
        }
    const double right = kWidth - 28 - kLetter * double(longest);
    const Scale x = scaleOf(curve.x, xs, kLeft, right);
    const double step = kPanel + kGap + kLine;
    const double height =
        kTop + kLine + step * double(curve.panels.size()) - kGap - kLine + kBottom;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" role=\"img\" font-family=\"sans-serif\" font-size=\"12\" "
        "fill=\"{2}\">\n<title>{3}</title>\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"#ffffff\"/>\n",
        kWidth, height, kTextColor, escaped(curve.title));
    svg += text(kLeft, 24, "start", curve.title,
                "font-size=\"16\" font-weight=\"600\" fill=\"#1d1c1a\"");
    for (std::size_t i = 0; i < curve.panels.size(); ++i)
        svg += panelSvg(curve.panels[i], curve.x, x, kTop + kLine + step * double(i), curve.marks);
    svg += marksSvg(curve.marks, x, kTop + kLine);
    svg += text((kLeft + right) / 2, height - 12, "middle", curve.x.label, "font-weight=\"600\"");
    return svg + "</svg>\n";
}

}  // namespace penumbra
