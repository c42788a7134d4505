// `./course zoo`: every hard case, naive variant and solution side by side.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/error.h"
#include "core/output_folder.h"
#include "scene/gallery.h"
#include "zoo/zoo.h"

namespace penumbra {
namespace {

int zoo(const std::filesystem::path& out, bool list) {
    const auto cases = zooCases();
    if (cases.empty()) throw Error("nothing to show", "autograder/", "this tree has no zoo.json");
    const auto drawn = assignmentsWithCurves();
    if (list) {
        for (const ZooCase& c : cases)
            fmt::print("{:<24} {:<72} {}, {}\n", c.assignment, c.failure, c.check, c.naive);
        for (const std::string& name : drawn) fmt::print("{:<24} curves\n", name);
        return 0;
    }
    Progress progress("zoo", long(cases.size() + drawn.size()));
    const auto rows = zooRows(PENUMBRA_BUILD, cases, progress);
    const auto curves = zooCurves(PENUMBRA_BUILD, drawn, progress);
    OutputFolder folder(out);
    writeText(folder.file("zoo.json"), zooJson(rows, curves));
    writeText(folder.file("zoo.html"), zooHtml(rows, curves));
    folder.commit();
    for (const ZooRow& r : rows)
        if (!r.holds())
            fmt::print("{} · {}: naive {}, solution {}\n", r.which.assignment, r.which.failure,
                       r.naive.passed     ? "keeps the bound"
                       : r.naive.answered ? "breaks it"
                                          : "gives no answer: " + r.naive.measured,
                       r.solution.passed ? "keeps it" : "breaks it");
    bool curvesHold = true;
    for (const ZooCurve& c : curves)
        if (!c.holds) {
            fmt::print("{} · {}: a fact does not hold\n", c.assignment, c.title);
            curvesHold = false;
        }
    const auto holding =
        std::count_if(rows.begin(), rows.end(), [](const ZooRow& r) { return r.holds(); });
    fmt::print("{} of {} cases hold; {} curves\n{}\n", holding, rows.size(), curves.size(),
               (out / "zoo.html").string());
    return holding == std::ptrdiff_t(rows.size()) && curvesHold ? 0 : 1;
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
    CLI::App app("Hard cases: naive variant, solution and bound");
    std::string out = (penumbra::repositoryRoot() / "out/zoo").string();
    app.add_option("--out", out, "folder of zoo.html and zoo.json");
    bool list = false;
    app.add_flag("--list", list, "name the cases, each checked against its grader's mistakes");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        fmt::print(stderr, "error: {}; see --help\n", e.what());
        return 2;
    }
    try {
        return penumbra::zoo(out, list);
    } catch (const std::exception& e) {
        fmt::print(stderr, "error: {}\n", e.what());
        return 2;
    }
}
