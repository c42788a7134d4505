#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/process.h"
#include "scene/gallery.h"
#include "zoo/zoo.h"

namespace penumbra {

namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool hasCurves(const fs::path& grader) {
    for (const auto& entry : fs::directory_iterator(grader))
        if (entry.path().filename().string().rfind("curves", 0) == 0 &&
            entry.path().extension() == ".cpp")
            return true;
    return false;
}

}  // namespace

std::vector<std::string> assignmentsWithCurves() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(repositoryRoot() / "autograder"))
        if (fs::exists(entry.path() / "rubric.json") && hasCurves(entry.path()) &&
            fs::is_directory(repositoryRoot() / "solutions" / entry.path().filename()))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<ZooCurve> zooCurves(const fs::path& build, const std::vector<std::string>& assignments,
                                Progress& progress) {
    const ScratchFolder scratch;
    std::vector<ZooCurve> curves;
    for (const std::string& name : assignments) {
        const fs::path out = scratch.path() / name;
        const Command command{.program = build / "bin" / (name + ".grade"),
                              .arguments = {"--curves", "--solution", "--out", out.string()},
                              .folder = scratch.path(),
                              .limits = {.wallSeconds = 300, .cpuSeconds = 600}};
        const ProcessResult result = runProcess(command);
        if (!fs::exists(out / "curves.json"))
            throw Error("no curves", name,
                        inWords(result, command.limits) + " " + result.standardError);
        const auto drawn = nlohmann::ordered_json::parse(contentOf(out / "curves.json"));
        for (const auto& c : drawn.at("curves")) {
            const std::string file = c.at("name");
            ZooCurve curve{.assignment = name,
                           .svg = contentOf(out / (file + ".svg")),
                           .json = c.dump(),
                           .title = c.value("title", file),
                           .says = c.value("says", ""),
                           .facts = {},
                           .holds = c.at("reasons").empty()};
            for (const auto& fact : c.at("facts"))
                curve.facts.push_back(std::string(fact.at("cause")) + ": " +
                                      std::string(fact.at("measured")) + ", allowed " +
                                      std::string(fact.at("tolerance")));
            curves.push_back(std::move(curve));
        }
        progress.advance();
    }
    return curves;
}

}  // namespace penumbra
