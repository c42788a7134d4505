#include "study/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/report.h"

namespace penumbra {

namespace {

constexpr double kLeft = 46, kRight = 12, kTop = 30, kBottom = 40;  // around the plot
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
          y_(each([](const StudyPoint& p) { return p.metrics.rmse; }), kPanelHeight - kBottom,
             kTop) {}

    std::string draw(const std::string& title, const StudyTruth* truth) const {
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
                         x_.end, kPanelHeight - 10, x_.end);
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
                kMarkerRadius, style.marker,
                escaped(fmt::format("{}: {}, {}: {:.2f} floors, RMSE {:.4f}", p->program, p->curve,
                                    p->settings.empty() ? "defaults" : p->settings,
                                    p->floors.median, p->metrics.rmse)));
        return svg + "</g>";
    }

    // The name of each curve that reaches the scene's front, where it covers no point or name.
    std::string labels() const {
        std::vector<Rectangle> taken;
        for (const StudyPoint* p : points_)
            taken.push_back({px(*p) - kMarkerRadius, py(*p) - kMarkerRadius, px(*p) + kMarkerRadius,
                             py(*p) + kMarkerRadius});
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
        constexpr double kHeight = 12, kGap = kMarkerRadius + 3;
        const double x = px(p), y = py(p);
        for (const glm::dvec2 corner : {glm::dvec2(x + kGap, y - kHeight / 2),
                                        {x - kGap - width, y - kHeight / 2},
                                        {x + 2, y - kGap - kHeight},
                                        {x - 2 - width, y + kGap},
                                        {x + 2, y + kGap},
                                        {x - 2 - width, y - kGap - kHeight}}) {
            const Rectangle r{corner.x, corner.y, corner.x + width, corner.y + kHeight};
            const bool inside = r.left > kLeft && r.right < width_ - kRight && r.top > kTop &&
                                r.bottom < kPanelHeight - kBottom;
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

}  // namespace

std::string drawPanel(const Points& points, double width, const std::vector<CurveStyle>& styles,
                      const std::string& title, const StudyTruth* truth) {
    return Panel(points, width, styles).draw(title, truth);
}

}  // namespace penumbra
