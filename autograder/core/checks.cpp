#include "core/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace penumbra {

namespace {

// A tolerance without a cause is a mistake of whoever wrote the check: a grader error.
void requireCause(const std::string& cause, const char* subject) {
    if (cause.empty())
        throw Error("a tolerance has no cause", subject, "say where the number comes from");
}

void record(Comparison comparison) {
    CheckRecord& check = GradingSession::current().check();
    if (!comparison.passed) {
        check.reasons.push_back(fmt::format("{}: {}, allowed {}", comparison.subject,
                                            comparison.measured, comparison.tolerance));
        GTEST_NONFATAL_FAILURE_(check.reasons.back().c_str());
    }
    check.comparisons.push_back(std::move(comparison));
}

// frame.at("visibility") -> visibility: what the report calls it.
std::string quotedPart(const std::string& expression) {
    const auto first = expression.find('"'), last = expression.rfind('"');
    return last > first ? expression.substr(first + 1, last - first - 1) : expression;
}

// Pictures need not be larger than a report shows them.
Image forReport(const Image& image) {
    constexpr int kSide = 384;
    const int step = (std::max(image.width, image.height) + kSide - 1) / kSide;
    if (step <= 1) return image;
    Image small(std::max(1, image.width / step), std::max(1, image.height / step), image.channels);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                small.at(x, y, c) = image.at(x * step, y * step, c);
    return small;
}

std::vector<unsigned char> picture(const Image& image) {
    return encodePng(forReport(image), image.channels >= 3 ? Encoding::srgb : Encoding::linear);
}

// Channels are averaged: the picture says where, not in which colour.
Image grey(const Image& image) {
    Image result(image.width, image.height, 1);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        float sum = 0;
        for (int c = 0; c < image.channels; ++c)
            sum += image.pixels[i * std::size_t(image.channels) + std::size_t(c)];
        result.pixels[i] = sum / float(image.channels);
    }
    return result;
}

Image differencePicture(const Image& mine, const Image& truth, const Image& mask) {
    Image colors = falseColorDifference(grey(mine), grey(truth));
    if (!mask.empty())
        for (std::size_t i = 0; i < mask.pixels.size(); ++i)
            if (mask.pixels[i] == 0.0f)  // not compared: grey
                for (std::size_t c = 0; c < 3; ++c)
                    colors.pixels[3 * i + c] = 0.55f + 0.25f * colors.pixels[3 * i + c];
    return colors;
}

struct ImageError {
    double mean = 0, maximum = 0, outliers = 0;
    int x = 0, y = 0;  // of the maximum
    std::size_t count = 0;
};

ImageError compare(const Image& mine, const Image& truth, const Image& mask,
                   double outlierDistance) {
    ImageError e;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            if (!mask.empty() && mask.at(x, y) == 0.0f) continue;
            double worst = 0;
            for (int c = 0; c < truth.channels; ++c)
                worst =
                    std::max(worst, std::abs(double(mine.at(x, y, c)) - double(truth.at(x, y, c))));
            ++e.count;
            e.mean += worst;
            e.outliers += worst > outlierDistance;
            if (worst > e.maximum) e.maximum = worst, e.x = x, e.y = y;
        }
    if (e.count > 0) e.mean /= double(e.count), e.outliers /= double(e.count);
    return e;
}

// One line a person can act on: the figures that are bounded, and where the worst pixel is.
void describe(const ImageError& e, const ImageTolerance& t, Comparison& comparison) {
    const auto add = [&](double value, double bound, const std::string& before,
                         const std::string& after) {
        if (!std::isfinite(bound)) return;
        const char* semicolon = comparison.measured.empty() ? "" : "; ";
        const double scale = after.empty() ? 1 : 100;  // a share is read in per cent
        comparison.measured += fmt::format("{}{}{:.3g}{}", semicolon, before, scale * value, after);
        comparison.tolerance +=
            fmt::format("{}{}at most {:.3g}{}", semicolon, before, scale * bound, after);
        comparison.passed = comparison.passed && value <= bound;
    };
    comparison.passed = e.count > 0;
    add(e.mean, t.mean, "mean difference ", "");
    add(e.maximum, t.maximum, "largest difference ", "");
    add(e.outliers, t.outliers, "",
        fmt::format(" % of pixels off by more than {:g}", t.outlierDistance));
    if (e.count == 0) comparison.measured = "no pixel to compare";
    if (!comparison.passed && e.maximum > 0)
        comparison.measured += fmt::format("; worst {:.3g} at pixel ({}, {})", e.maximum, e.x, e.y);
}

const char* symbol(Relation relation) {
    switch (relation) {
        case Relation::Less:
            return "less than";
        case Relation::LessOrEqual:
            return "at most";
        case Relation::Greater:
            return "more than";
        case Relation::GreaterOrEqual:
            return "at least";
        case Relation::Equal:
            return "exactly";
    }
    return "";
}

bool holds(double a, Relation relation, double b) {
    switch (relation) {
        case Relation::Less:
            return a < b;
        case Relation::LessOrEqual:
            return a <= b;
        case Relation::Greater:
            return a > b;
        case Relation::GreaterOrEqual:
            return a >= b;
        case Relation::Equal:
            return a == b;
    }
    return false;
}

std::string vectorText(const glm::vec4& v, int components) {
    std::string text = components == 1 ? "" : "(";
    for (int c = 0; c < components; ++c) text += fmt::format("{}{:.6g}", c ? ", " : "", v[c]);
    return components == 1 ? text : text + ")";
}

}  // namespace

const Image& Rendered::at(const std::string& image) const {
    const auto it = frame_->images.find(image);
    if (it == frame_->images.end())
        throw Error("the check reads an image that it did not ask for", image, "add it to .images");
    return it->second;
}

Rendered render(const RenderRequest& request) {
    return Rendered(GradingSession::current().render(request));
}

std::vector<glm::vec4> evaluate(const EvaluateRequest& request) {
    return GradingSession::current().evaluate(request);
}

std::string sceneFile(const Scene& scene) { return GradingSession::current().sceneFile(scene); }

void expectImageNear(const char* subject, const Image& mine, const Image& truth,
                     const ImageTolerance& tolerance, const Image& mask) {
    requireCause(tolerance.cause, subject);
    if (!std::isfinite(std::min({tolerance.mean, tolerance.maximum, tolerance.outliers})))
        throw Error("a tolerance bounds nothing", subject, "give .mean, .maximum or .outliers");
    if (nonFiniteCount(truth) > 0 || truth.empty())
        throw Error("the truth has no finite value somewhere", subject, "repair the check");
    if (!mask.empty() &&
        (mask.width != truth.width || mask.height != truth.height || mask.channels != 1))
        throw Error("the mask's shape differs from the truth's", subject, "repair the check");
    Comparison comparison{.subject = quotedPart(subject), .cause = tolerance.cause};
    if (!mine.sameShape(truth)) {
        comparison.measured =
            fmt::format("{}x{} with {} channels", mine.width, mine.height, mine.channels);
        comparison.tolerance =
            fmt::format("{}x{} with {} channels", truth.width, truth.height, truth.channels);
        return record(std::move(comparison));
    }
    describe(compare(mine, truth, mask, tolerance.outlierDistance), tolerance, comparison);
    if (!comparison.passed || GradingSession::current().picturesOfPassed()) {
        comparison.mine = picture(mine);
        comparison.truth = picture(truth);
        comparison.difference =
            encodePng(forReport(differencePicture(mine, truth, mask)), Encoding::linear);
    }
    record(std::move(comparison));
}

void expectValue(const char* subject, double measured, Relation relation, double bound,
                 const std::string& cause) {
    requireCause(cause, subject);
    if (std::isnan(bound)) throw Error("the bound is not a number", subject, "repair the check");
    record({.subject = subject,
            .measured = fmt::format("{:.6g}", measured),
            .tolerance = fmt::format("{} {:.6g}", symbol(relation), bound),
            .cause = cause,
            .passed = holds(measured, relation, bound)});
}

void expectRowsNear(const char* subject, std::span<const glm::vec4> mine,
                    std::span<const glm::vec4> truth, const RowTolerance& t) {
    requireCause(t.cause, subject);
    if (mine.size() != truth.size() || truth.empty())
        throw Error("rows and truths differ in number", subject, "repair the check");
    std::size_t wrong = 0, worstRow = 0;
    double worst = -1;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        double excess = 0;
        for (int c = 0; c < t.components; ++c)
            excess =
                std::max(excess, std::abs(double(mine[i][c]) - double(truth[i][c])) /
                                     (t.absolute + t.relative * std::abs(double(truth[i][c]))));
        wrong += !(excess <= 1);
        if (!(excess <= worst)) worst = excess, worstRow = i;
    }
    record(
        {.subject = subject,
         .measured = fmt::format("{} of {} rows off; worst is row {}: {}, truth {}", wrong,
                                 truth.size(), worstRow, vectorText(mine[worstRow], t.components),
                                 vectorText(truth[worstRow], t.components)),
         .tolerance = fmt::format("{:g} + {:g} of the value", t.absolute, t.relative),
         .cause = t.cause,
         .passed = wrong == 0});
}

}  // namespace penumbra
