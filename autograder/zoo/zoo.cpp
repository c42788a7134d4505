#include "zoo/zoo.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/mistakes.h"
#include "core/process.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path graderOf(const std::string& assignment) {
    return repositoryRoot() / "autograder" / assignment;
}

Mistake mistakeNamed(const ZooCase& c) {
    const auto mistakes = loadMistakes(graderOf(c.assignment) / "wrong");
    const auto it = std::find_if(mistakes.begin(), mistakes.end(),
                                 [&](const Mistake& m) { return m.folder == c.naive; });
    if (it == mistakes.end() || it->fails.count(c.check) == 0)
        throw Error("the naive variant '" + c.naive + "' does not fail " + c.check,
                    "autograder/" + c.assignment + "/zoo.json", "name one that does");
    return *it;
}

// The record of one check of one variant.
json gradeOnly(const fs::path& build, const ZooCase& c, bool solution, const fs::path& scratch) {
    const fs::path record = scratch / "record.json";
    std::vector<std::string> arguments = {"--only",         c.check,
                                          "--out",          (scratch / "out").string(),
                                          "--record",       record.string(),
                                          "--truth-cache",  (scratch / "truths").string(),
                                          "--shader-cache", (scratch / "shaders").string()};
    if (solution)
        arguments.emplace_back("--solution");
    else
        arguments.insert(arguments.end(), {"--wrong", c.naive});
    fs::remove(record);
    const Command command{.program = build / "bin" / (c.assignment + ".grade"),
                          .arguments = arguments,
                          .folder = scratch,
                          .limits = {.wallSeconds = 300, .cpuSeconds = 600}};
    const ProcessResult result = runProcess(command);
    std::ifstream stream(record);
    if (!stream)
        throw Error("no grade of " + c.check, c.assignment,
                    inWords(result, command.limits) + " " + result.standardError);
    return json::parse(stream).at("checks").at(0);
}

ZooResult resultOf(const json& check, std::size_t comparison) {
    ZooResult result{.measured = "", .passed = check.at("verdict") == "pass"};
    const json& all = check.at("comparisons");
    if (comparison < all.size()) {
        result.answered = true;
        const json& c = all.at(comparison);
        result.measured = c.at("measured");
        result.mine = c.at("mine");
        result.difference = c.at("difference");
    } else if (!check.at("reasons").empty()) {
        result.measured = check.at("reasons").at(0);
        result.answered = result.measured.starts_with("writes ");  // NaN: see core/runner.cpp
    }
    return result;
}

ZooRow rowOf(const fs::path& build, const ZooCase& c, const fs::path& scratch) {
    const Mistake mistake = mistakeNamed(c);
    const json naive = gradeOnly(build, c, false, scratch);
    const json solution = gradeOnly(build, c, true, scratch);
    // The first comparison that the naive variant fails; a variant without a frame has none.
    const json& tried = naive.at("comparisons");
    std::size_t index = 0;
    while (index < tried.size() && tried.at(index).at("passed")) ++index;
    ZooRow row{.which = c,
               .sentence = naive.at("sentence"),
               .mistake = mistake.name,
               .subject = "",
               .bound = "",
               .cause = "",
               .naive = resultOf(naive, index),
               .solution = resultOf(solution, index)};
    const json& good = solution.at("comparisons");
    if (good.empty()) return row;
    const json& shown = good.at(std::min(index, good.size() - 1));
    row.subject = shown.at("subject");
    row.bound = shown.at("tolerance");
    row.cause = shown.at("cause");
    row.truth = shown.at("truth");
    row.solution = resultOf(solution, std::min(index, good.size() - 1));
    return row;
}

}  // namespace

std::vector<ZooCase> zooCases() {
    std::vector<fs::path> plans;
    for (const auto& entry : fs::directory_iterator(repositoryRoot() / "autograder"))
        if (fs::exists(entry.path() / "zoo.json") &&
            fs::is_directory(repositoryRoot() / "solutions" / entry.path().filename()))
            plans.push_back(entry.path() / "zoo.json");
    std::sort(plans.begin(), plans.end());
    std::vector<ZooCase> cases;
    for (const fs::path& plan : plans) {
        std::ifstream stream(plan);
        try {
            const json parsed = json::parse(stream);
            for (const json& c : parsed.at("cases"))
                cases.push_back({plan.parent_path().filename().string(), c.at("failure"),
                                 c.at("check"), c.at("naive")});
        } catch (const json::exception& e) {
            throw Error(e.what(), plan.string(), "see the example in autograder/zoo/zoo.h");
        }
    }
    for (const ZooCase& c : cases) mistakeNamed(c);  // complain before the work
    return cases;
}

std::vector<ZooRow> zooRows(const fs::path& build, const std::vector<ZooCase>& cases,
                            Progress& progress) {
    const ScratchFolder scratch;
    std::vector<ZooRow> rows;
    for (const ZooCase& c : cases) {
        rows.push_back(rowOf(build, c, scratch.path()));
        progress.advance();
    }
    return rows;
}

std::string zooJson(const std::vector<ZooRow>& rows, const std::vector<ZooCurve>& curves) {
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    for (const ZooRow& r : rows)
        cases.push_back(
            {{"assignment", r.which.assignment},
             {"failure", r.which.failure},
             {"check", r.which.check},
             {"sentence", r.sentence},
             {"subject", r.subject},
             {"bound", r.bound},
             {"cause", r.cause},
             {"naive",
              {{"variant", r.which.naive},
               {"what", r.mistake},
               {"measured", r.naive.measured},
               {"keeps_bound", r.naive.passed}}},
             {"solution", {{"measured", r.solution.measured}, {"keeps_bound", r.solution.passed}}},
             {"holds", r.holds()}});
    nlohmann::ordered_json drawn = nlohmann::ordered_json::array();
    for (const ZooCurve& c : curves) {
        auto entry = nlohmann::ordered_json::parse(c.json);
        entry["assignment"] = c.assignment;
        drawn.push_back(std::move(entry));
    }
    return nlohmann::ordered_json{{"cases", cases}, {"curves", drawn}}.dump(2) + "\n";
}

}  // namespace penumbra
