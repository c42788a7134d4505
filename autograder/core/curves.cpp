#include "core/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/grade.h"
#include "core/output_folder.h"

namespace penumbra {

namespace {

using nlohmann::ordered_json;

// By name: the order in which objects are linked is nobody's business.
std::map<std::string, Curve (*)()>& registered() {
    static std::map<std::string, Curve (*)()> curves;
    return curves;
}

ordered_json toJson(double value) {
    if (std::isfinite(value)) return value;
    return fmt::format("{}", value);  // JSON has no word for nan and inf
}

ordered_json toJson(const PlotAxis& axis) { return {{"label", axis.label}, {"log", axis.log}}; }

ordered_json toJson(const Curve& curve) {
    ordered_json panels = ordered_json::array(), marks = ordered_json::array();
    for (const PlotPanel& panel : curve.panels) {
        ordered_json all = ordered_json::array();
        for (const PlotSeries& s : panel.series) {
            ordered_json points = ordered_json::array();
            for (const glm::dvec2& p : s.points) points.push_back({toJson(p.x), toJson(p.y)});
            all.push_back({{"name", s.name}, {"formula", s.formula}, {"points", points}});
        }
        panels.push_back({{"y", toJson(panel.y)}, {"series", all}});
    }
    for (const PlotMark& m : curve.marks) marks.push_back({{"x", m.x}, {"label", m.label}});
    return {{"name", curve.name},   {"title", curve.title}, {"says", curve.says},
            {"x", toJson(curve.x)}, {"panels", panels},     {"marks", marks}};
}

ordered_json factsOf(const CheckRecord& record) {
    ordered_json facts = ordered_json::array();
    for (const Comparison& c : record.comparisons)
        facts.push_back({{"subject", c.subject},
                         {"measured", c.measured},
                         {"tolerance", c.tolerance},
                         {"cause", c.cause},
                         {"passed", c.passed}});
    return facts;
}

}  // namespace

bool registerCurve(const char* name, Curve (*measure)()) {
    std::string file = name;
    std::replace(file.begin(), file.end(), '_', '-');
    return registered().emplace(file, measure).second;
}

int drawCurves(const Place& place, const Variant& variant, const CurveOptions& options) {
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());  // facts are in the record
    GradingSession session(
        variant.program,
        {.truths = options.truthCache.empty() ? TruthCache() : TruthCache(options.truthCache),
         .picturesOfPassed = false});
    OutputFolder folder(options.out);
    ordered_json all = ordered_json::array();
    bool hold = true;
    for (const auto& [name, measure] : registered()) {
        if (!options.only.empty() && !matches(options.only, name)) continue;
        session.begin("Curves", name);
        ordered_json entry = {{"name", name}};
        try {
            Curve curve = measure();
            curve.name = name;
            writeText(folder.file(name + ".svg"), curveSvg(curve));
            entry = toJson(curve);
        } catch (const NoFrame&) {  // the record has the reason
        }
        const CheckRecord record = session.end();
        if (record.comparisons.empty() && record.reasons.empty())
            throw Error("a curve states no fact", name, "end it with EXPECT_VALUE");
        entry["facts"] = factsOf(record);
        entry["reasons"] = record.reasons;
        all.push_back(std::move(entry));
        hold = hold && record.reasons.empty();
        fmt::print("{:<28} {} facts, {:.1f} s\n", name, record.comparisons.size(), record.seconds);
        for (const std::string& reason : record.reasons)
            fmt::print("  does not hold: {}\n", reason);
    }
    if (all.empty())
        throw Error("no curve to draw", place.assignment,
                    "curves are written in autograder/" + place.assignment + "/curves.cpp");
    writeText(
        folder.file("curves.json"),
        ordered_json{{"assignment", place.assignment}, {"variant", variant.name}, {"curves", all}}
                .dump(2) +
            "\n");
    folder.commit();
    return hold ? 0 : 1;
}

}  // namespace penumbra
