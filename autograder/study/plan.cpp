#include "study/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "scene/gallery.h"

namespace penumbra {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> foldersWithPlan(const fs::path& parent) {
    std::vector<std::string> names;
    if (!fs::is_directory(parent)) return names;
    for (const auto& entry : fs::directory_iterator(parent))
        if (fs::exists(entry.path() / "study.json"))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

// The assignments that `names` mean; all of them where there are none.
std::vector<std::string> chosen(const std::vector<std::string>& known,
                                const std::vector<std::string>& names) {
    if (names.empty()) return known;
    std::vector<std::string> result;
    for (const std::string& name : names) {
        std::vector<std::string> fits;
        for (const std::string& candidate : known)
            if (candidate == name || candidate.find(name) != std::string::npos)
                fits.push_back(candidate);
        if (fits.size() != 1)
            throw Error(fits.empty() ? "no such assignment" : "more than one assignment fits", name,
                        fmt::format("choose of {}", fmt::join(fits.empty() ? known : fits, " ")));
        result.push_back(fits.front());
    }
    return result;
}

}  // namespace

std::vector<StudyCurve> loadCurves(const fs::path& file) {
    std::ifstream stream(file);
    if (!stream) throw Error("no plan for the study", file.string(), "write it: see study/plan.h");
    try {
        const nlohmann::json plan = nlohmann::json::parse(stream);
        std::vector<StudyCurve> curves;
        for (const auto& json : plan.at("curves"))
            curves.push_back({json.at("name"), json.at("points"), json.at("quick")});
        for (const StudyCurve& curve : curves)
            for (const std::string& point : curve.quick)
                if (std::find(curve.points.begin(), curve.points.end(), point) ==
                    curve.points.end())
                    throw Error("quick point '" + point + "' is none of the curve's points",
                                file.string() + ", curve " + curve.name, "take one of them");
        return curves;
    } catch (const nlohmann::json::exception& e) {
        throw Error(e.what(), file.string(), "see the example in autograder/study/plan.h");
    }
}

std::vector<StudyProgram> studyPrograms(const fs::path& build,
                                        const std::vector<std::string>& names,
                                        const fs::path& submission) {
    const fs::path autograder = repositoryRoot() / "autograder";
    std::vector<std::string> known = foldersWithPlan(autograder);
    if (!submission.empty() && names.size() != 1)
        throw Error("a submission is to one assignment", "--submission " + submission.string(),
                    fmt::format("name it: choose of {}", fmt::join(known, " ")));
    std::vector<StudyProgram> programs;
    for (const std::string& name : chosen(known, names)) {
        const Place place{.root = repositoryRoot(), .build = build, .assignment = name};
        auto curves = loadCurves(autograder / name / "study.json");
        if (fs::is_directory(repositoryRoot() / "solutions" / name))
            programs.push_back({name, solutionVariant(place).program, curves});
        if (submission.empty()) continue;
        const Variant variant = submissionVariant(place, submission);
        if (!variant.program.broken.empty())
            throw Error(variant.program.broken, submission.string(), "mend it first");
        for (StudyCurve& curve : curves) curve.name = variant.name + ": " + curve.name;
        programs.push_back({.name = name + " of " + variant.name,
                            .program = variant.program,
                            .curves = curves,
                            .submission = true});
    }
    const fs::path competitors = autograder / "study/competitors";
    for (const std::string& name : foldersWithPlan(competitors))
        programs.push_back({.name = name,
                            .program = {.executable = build / "bin" / ("study." + name)},
                            .curves = loadCurves(competitors / name / "study.json"),
                            .competitor = true});
    return programs;
}

std::vector<std::string> studyScenes(bool quick) {
    std::vector<std::string> scenes = {"boxes", "fence", "foliage", "stairs"};
    if (!quick)
        for (const char* name : {"halfplane", "polygon", "antiqueChair", "spiralStaircase", "bush"})
            scenes.emplace_back(name);
    return scenes;
}

}  // namespace penumbra
