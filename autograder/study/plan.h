// What the study measures: each program's curves, declared in a study.json beside its grader
// (autograder/NN-name/study.json, autograder/study/competitors/<name>/study.json).
//
//   {"curves": [{"name": "PCSS",
//                "points": ["search_samples=3,filter_samples=4",
//                "search_samples=4,filter_samples=8"], "quick":
//                ["search_samples=4,filter_samples=8"]}]}
//
// A point is the settings that differ from the defaults; "" is the defaults. `quick` is a part of
// the points: what `--quick` measures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/runner.h"
#include "core/variant.h"

namespace penumbra {

struct StudyCurve {
    std::string name;
    std::vector<std::string> points, quick;
};

struct StudyProgram {
    std::string name;  // 06-pcss, 06-pcss of ada, rays
    VariantProgram program;
    std::vector<StudyCurve> curves;
    bool competitor = false;
    bool submission = false;
};

// Throws Error for a file that is missing, is no JSON or breaks the rules above.
std::vector<StudyCurve> loadCurves(const std::filesystem::path& file);

// Every assignment with a study.json and a solution, or only those that `names` (shortened as
// ./course does) say; then the competitors. `submission`, a student's folder, comes after the one
// named assignment's solution; its curves are named for the folder. Throws Error for a name that
// fits none or several.
std::vector<StudyProgram> studyPrograms(const std::filesystem::path& build,
                                        const std::vector<std::string>& names,
                                        const std::filesystem::path& submission);

// Four gallery scenes; in full, closed forms and models as well.
std::vector<std::string> studyScenes(bool quick);

}  // namespace penumbra
