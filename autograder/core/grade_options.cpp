// The command line of N.grade.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/curves.h"
#include "core/error.h"
#include "core/grade.h"
#include "core/handout_hash.h"
#include "core/mistakes.h"
#include "core/output_folder.h"
#include "core/report.h"

namespace penumbra {

namespace {

struct Options {
    bool solution = false;
    std::string mistake, submission, out, only, truthCache, shaderCache, expectSame, record;
    bool expectMistake = false, expectNotStarted = false;
    bool handoutHashes = false, buildOnly = false, curves = false;
};

void declare(CLI::App& app, Options& o) {
    auto* solution = app.add_flag("--solution", o.solution, "grade the solution");
    auto* mistake =
        app.add_option("--wrong", o.mistake, "grade a known mistake: a folder of wrong/");
    auto* submission =
        app.add_option("--submission", o.submission, "grade the files in this folder");
    solution->excludes(mistake)->excludes(submission);
    mistake->excludes(submission);
    app.add_option("--out", o.out, "folder for results.json, junit.xml, report.html");
    app.add_option("--only", o.only, "run checks that match: Task3*");
    app.add_option("--truth-cache", o.truthCache,
                   "keep truths in this folder for later runs; whoever can write there decides "
                   "what is true");
    app.add_option("--shader-cache", o.shaderCache,
                   "keep compiled shaders and distance fields in this folder for later runs; the "
                   "programs under test write there");
    app.add_option("--record", o.record, "also write every comparison with its pictures here");
    app.add_flag(
        "--curves", o.curves,
        "instead of grading, draw what curves.cpp measures: an .svg each, and curves.json");
    app.add_flag("--expect-mistake", o.expectMistake, "succeed if exactly the named checks fail")
        ->needs(mistake);
    app.add_flag("--expect-not-started", o.expectNotStarted, "succeed if no task has been started");
    app.add_option("--expect-same", o.expectSame,
                   "succeed if an earlier run's results.json in this folder has the same verdicts "
                   "and numbers");
    app.add_flag("--handout-hashes", o.handoutHashes,
                 "print the handout's hashes; fail where rubric.json differs");
    app.add_flag("--build-only", o.buildOnly, "build a submission and print its program")
        ->needs(submission);
}

Variant chosen(const Place& place, const Options& o) {
    if (o.solution) return solutionVariant(place);
    if (!o.mistake.empty()) return mistakeVariant(place, o.mistake);
    if (!o.submission.empty()) return submissionVariant(place, o.submission);
    return handoutVariant(place);
}

int printHashes(const Place& place) {
    std::string text;
    std::map<std::string, std::string> hashes;
    for (const auto& file : studentFiles(place)) {
        hashes[file] = contentHash(place.handout() / file);
        text += fmt::format("{}\"{}\": \"{}\"", text.empty() ? "" : ",\n            ", file,
                            hashes[file]);
    }
    fmt::print("\"handout\": {{{}}}\n", text);
    std::ifstream exists(place.grader() / "rubric.json");
    if (!exists) return 1;
    for (const auto& [file, hash] : loadRubric(place.grader() / "rubric.json").handoutHashes)
        if (hashes.count(file) == 0 || hashes[file] != hash) {
            fmt::print(stderr, "rubric.json differs: {}\n", file);
            return 1;
        }
    return 0;
}

int buildOnly(const Variant& variant) {
    if (!variant.program.broken.empty())
        throw Error(variant.program.broken, variant.name, "fix the line");
    fmt::print("{}\n", variant.program.executable.string());
    return 0;
}

// Exactly the checks that the mistake names must fail, no more and no fewer.
int compareWithMistake(const Place& place, const std::string& folder, const GradeRecord& grade) {
    const auto failed = failedChecks(grade);
    for (const auto& mistake : loadMistakes(place.grader() / "wrong")) {
        if (mistake.folder != folder) continue;
        for (const auto& check : mistake.fails)
            if (failed.count(check) == 0)
                fmt::print(stderr, "should fail but does not: {}\n", check);
        for (const auto& check : failed)
            if (mistake.fails.count(check) == 0)
                fmt::print(stderr, "fails but is not named: {}\n", check);
        if (exitCode(grade) > 1) return exitCode(grade);
        return failed == mistake.fails ? 0 : 1;
    }
    return 2;
}

int expectNotStarted(const GradeRecord& grade) {
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks)
            if (check.verdict != Verdict::notStarted) {
                fmt::print(stderr, "{}: {}\n", check.sentence, toString(check.verdict));
                return 1;
            }
    return pointsOf(grade) == 0 ? 0 : 1;
}

// All but times and memory: names, points, verdicts, and every number that was measured.
int compareWithEarlier(const std::string& folder, const std::string& out) {
    const auto load = [](const std::string& of) {
        std::ifstream stream(std::filesystem::path(of) / "results.json");
        if (!stream) throw Error("no earlier results", of, "grade into that folder first");
        return nlohmann::json::parse(stream);
    };
    const auto before = load(folder), now = load(out);
    for (std::size_t i = 0; i < std::min(before["tests"].size(), now["tests"].size()); ++i)
        if (before["tests"][i] != now["tests"][i])
            fmt::print(stderr, "before: {}\nnow:    {}\n", before["tests"][i].dump(),
                       now["tests"][i].dump());
    return before["score"] == now["score"] && before["tests"] == now["tests"] ? 0 : 1;
}

int run(const Place& place, const Options& o) {
    if (o.handoutHashes) return printHashes(place);
    if (!o.buildOnly && o.out.empty())
        throw Error("no --out", "command line", "give a folder for the report");
    if (!o.buildOnly && !o.curves) prepareOut(o.out);
    Variant variant = chosen(place, o);
    if (o.buildOnly) return buildOnly(variant);
    // The programs work in a folder of their own.
    if (!o.shaderCache.empty()) {
        std::filesystem::create_directories(o.shaderCache);
        variant.program.shaderCache = std::filesystem::absolute(o.shaderCache);
    }
    if (o.curves)
        return drawCurves(place, variant,
                          {.only = o.only, .out = o.out, .truthCache = o.truthCache});
    const GradeRecord grade =
        gradeVariant(place, variant,
                     {.only = o.only,
                      .picturesOfPassed = !o.expectMistake,  // a test's report is seldom read
                      .truthCache = o.truthCache});
    writeReports(o.out, grade);
    if (!o.record.empty()) writeText(o.record, recordJson(grade));
    printTable(grade, o.out);
    if (o.expectMistake) return compareWithMistake(place, o.mistake, grade);
    if (!o.expectSame.empty()) return compareWithEarlier(o.expectSame, o.out);
    if (o.expectNotStarted) return expectNotStarted(grade);
    return exitCode(grade);
}

}  // namespace

int gradeMain(int argc, char** argv, const Place& place) {
    Options options;
    CLI::App app("Grades " + place.assignment, place.assignment + ".grade");
    declare(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        fmt::print("{}", app.help());
        return 0;
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "error: {}: command line; see --help\n", error.what());
        return 2;
    }
    try {
        int noArguments = 1;
        testing::InitGoogleTest(&noArguments, argv);
        return run(place, options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return 2;
    }
}

}  // namespace penumbra
