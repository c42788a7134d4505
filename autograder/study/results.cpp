#include "study/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace penumbra {

namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const Spread& s) {
    return {{"minimum", s.minimum}, {"median", s.median}, {"maximum", s.maximum}};
}

Json jsonOf(const Metrics& m) {
    return {{"rmse", m.rmse},
            {"mean_absolute", m.meanAbsolute},
            {"percentile_99", m.percentile99},
            {"penumbra_rmse", m.penumbraRmse},
            {"false_shadow_rate", m.falseShadowRate},
            {"light_leak_rate", m.lightLeakRate}};
}

Json jsonOf(const StudyPoint& p) {
    Json json = {{"program", p.program},      {"curve", p.curve}, {"scene", p.scene},
                 {"settings", p.settings},    {"light", p.light}, {"competitor", p.competitor},
                 {"submission", p.submission}};
    if (!p.error.empty()) {
        json["error"] = p.error;
        return json;
    }
    json["metrics"] = jsonOf(p.metrics);
    json["frame_ms"] = jsonOf(p.frame);
    json["floor_ms"] = jsonOf(p.floor);
    json["floors"] = jsonOf(p.floors);
    json["wall_ms"] = jsonOf(p.wall);
    json["passes_ms"] = p.passes;
    json["texture_bytes"] = p.textureBytes;
    json["front"] = p.front;
    if (!p.notes.empty()) json["notes"] = p.notes;
    return json;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + "\"";
}

// "light=1.2;shade=3.4": median milliseconds
std::string passesText(const StudyPoint& p) {
    std::string text;
    for (const auto& [pass, ms] : p.passes)
        text += fmt::format("{}{}={:.4g}", text.empty() ? "" : ";", pass, ms);
    return text;
}

}  // namespace

Spread spread(std::vector<double> values) {
    EXPECTS(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return {values.front(), 0.5 * (values[(n - 1) / 2] + values[n / 2]), values.back()};
}

std::string StudyTruth::text() const {
    if (samples == 0) return "closed form";
    if (samples == 1) return "one ray to the light's centre";
    return fmt::format("{} rays, standard error {:.4f}", samples, standardError);
}

void findFronts(std::vector<StudyPoint>& points) {
    for (StudyPoint& p : points)
        p.front = p.error.empty() &&
                  std::none_of(points.begin(), points.end(), [&](const StudyPoint& other) {
                      return other.error.empty() && other.scene == p.scene &&
                             other.light == p.light && other.floors.median <= p.floors.median &&
                             other.metrics.rmse <= p.metrics.rmse &&
                             (other.floors.median < p.floors.median ||
                              other.metrics.rmse < p.metrics.rmse);
                  });
}

std::string studyJson(const StudyResults& r) {
    Json json = {{"date", r.date},
                 {"commit", r.commit},
                 {"processor", r.processor},
                 {"gl",
                  {{"renderer", r.renderer},
                   {"version", r.version},
                   {"timer", r.timer},
                   {"totals_timer", r.totalsTimer}}},
                 {"size", {r.size.x, r.size.y}},
                 {"quick", r.quick},
                 {"repetitions", r.repetitions},
                 {"warnings", r.warnings}};
    for (const StudyTruth& t : r.truths)
        json["truths"].push_back({{"scene", t.scene},
                                  {"light", t.light},
                                  {"kind", t.text()},
                                  {"samples", t.samples},
                                  {"standard_error", t.standardError}});
    for (const StudyPoint& p : r.points) json["points"].push_back(jsonOf(p));
    return json.dump(2) + "\n";
}

std::string studyCsv(const StudyResults& r) {
    std::string csv =
        "scene,light,program,curve,settings,rmse,mean_absolute,percentile_99,penumbra_rmse,"
        "false_shadow_rate,light_leak_rate,floors_median,floors_minimum,floors_maximum,"
        "frame_ms_median,floor_ms_median,wall_ms_median,passes,texture_bytes,front,error,truth\n";
    for (const StudyPoint& p : r.points) {
        const auto truth = std::find_if(r.truths.begin(), r.truths.end(), [&](const StudyTruth& t) {
            return t.scene == p.scene && t.light == p.light;
        });
        const std::string kind = truth == r.truths.end() ? "" : quoted(truth->text());
        const Metrics& m = p.metrics;
        csv += fmt::format("{},{},{},{},{},", p.scene, p.light, quoted(p.program), quoted(p.curve),
                           quoted(p.settings));
        if (p.error.empty())
            csv += fmt::format(
                "{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g},"
                "{:.4g},{:.4g},{:.4g},{},{:.0f},{},,{}\n",
                m.rmse, m.meanAbsolute, m.percentile99, m.penumbraRmse, m.falseShadowRate,
                m.lightLeakRate, p.floors.median, p.floors.minimum, p.floors.maximum,
                p.frame.median, p.floor.median, p.wall.median, quoted(passesText(p)),
                p.textureBytes, p.front ? 1 : 0, kind);
        else
            csv += ",,,,,,,,,,,,,,," + quoted(p.error) + "," + kind + "\n";
    }
    return csv;
}

}  // namespace penumbra
