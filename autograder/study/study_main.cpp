// `./course study`: what every technique costs and how far it is from the truth, on the same scenes
// in the same run.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <fstream>

#include "core/error.h"
#include "core/output_folder.h"
#include "core/process.h"
#include "scene/gallery.h"
#include "study/measure.h"
#include "study/page.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> names, scenes;
    std::string out = (repositoryRoot() / "out/study").string(), submission;
    bool quick = false, resume = false;
};

std::string processorName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
    return "unknown";
}

std::string commitName() {
    const ScratchFolder scratch;
    const ProcessResult git = runProcess(
        {.program = "/usr/bin/git",
         .arguments = {"-C", repositoryRoot().string(), "describe", "--always", "--dirty"},
         .folder = scratch.path()});
    std::string name = git.standardOutput;
    while (!name.empty() && name.back() == '\n') name.pop_back();
    return name.empty() ? "unknown" : name;
}

void printTable(const StudyResults& results) {
    fmt::print("{:<18} {:<26} {:<44} {:>8} {:>9}\n", "scene", "technique", "settings", "floors",
               "RMSE");
    for (const StudyPoint& p : results.points)
        if (!p.error.empty())
            fmt::print("{:<18} {:<26} {:<44} {}\n", p.scene, p.curve, p.settings, p.error);
        else if (p.front)
            fmt::print("{:<18} {:<26} {:<44} {:>8.2f} {:>9.4f}\n", p.scene, p.curve, p.settings,
                       p.floors.median, p.metrics.rmse);
    for (const std::string& warning : results.warnings) fmt::print("{}\n", warning);
}

void study(const fs::path& build, const Options& o) {
    // Answers stay beside the output until all of it is there.
    fs::path out = fs::absolute(o.out).lexically_normal();
    if (!out.has_filename()) out = out.parent_path();  // "out/study/"
    const fs::path kept = out.parent_path() / (out.filename().string() + ".measured");
    if (!o.resume) fs::remove_all(kept);
    StudyRequest request{.programs = studyPrograms(build, o.names, o.submission),
                         .scenes = o.scenes.empty() ? studyScenes(o.quick) : o.scenes,
                         .quick = o.quick,
                         .kept = kept};
    if (o.quick) {
        request.size = glm::ivec2(256);
        request.rounds = 1;
        request.repetitions = 9;
        request.truthSamples = 256;
    }
    StudyResults results = measure(request);
    results.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
    results.commit = commitName();
    results.processor = processorName();
    OutputFolder folder(out);
    writeText(folder.file("study.json"), studyJson(results));
    writeText(folder.file("study.csv"), studyCsv(results));
    writeText(folder.file("study.svg"), studySvg(results));
    writeText(folder.file("study.html"), studyHtml(results));
    folder.commit();
    fs::remove_all(kept);
    printTable(results);
    fmt::print("{}\n", (out / "study.html").string());
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
    penumbra::Options o;
    CLI::App app("Speed against error of every technique");
    app.add_option("names", o.names, "assignments, shortened or not; all of them where none");
    app.add_option("--scene", o.scenes, "only these scenes");
    app.add_option("--submission", o.submission,
                   "a student's folder: its curve beside the solution's");
    app.add_option("--out", o.out, "folder of study.html, .json, .csv, .svg");
    app.add_flag("--quick", o.quick, "few points, small pictures: under 3 minutes");
    app.add_flag("--resume", o.resume, "go on where an interrupted study stopped");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        fmt::print(stderr, "error: {}; see --help\n", e.what());
        return 2;
    }
    try {
        penumbra::study(PENUMBRA_BUILD, o);
        return 0;
    } catch (const std::exception& e) {
        fmt::print(stderr, "error: {}\n", e.what());
        return 2;
    }
}
