// Hard cases: what the naive variant does, what the solution does, and the bound between them. A
// case is a check of an assignment and one of its known mistakes, named in
// autograder/NN-name/zoo.json:
//
//   {"cases": [{"failure": "caster near the light's height: w goes to 0",
//               "check": "Task5RayForm.StaysAccurateAsTheCasterNearsTheLightsHeight",
//               "naive": "ray-is-the-matrix"}]}
//
// Truth, bound and its cause are the check's own, so that ./course test holds every one of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"

namespace penumbra {

struct ZooCase {
    std::string assignment, failure, check, naive;
};

// What one variant got in the comparison that tells the two apart.
struct ZooResult {
    std::string measured;                    // "rmse 0.0123"; or why there is no frame
    bool passed = false;                     // the whole check
    bool answered = false;                   // a frame came, if only one of NaN
    std::string mine = "", difference = "";  // PNG in base64, "" where no images are compared
};

struct ZooRow {
    ZooCase which;
    std::string sentence, mistake;  // the check and the naive variant in words
    std::string subject, bound, cause;
    ZooResult naive, solution;
    std::string truth = "";  // PNG in base64
    // A program that crashes breaks no bound.
    bool holds() const { return solution.passed && naive.answered && !naive.passed; }
};

// Of every assignment that has a zoo.json and a solution. Throws Error for a case that names no
// check or no mistake.
std::vector<ZooCase> zooCases();

// Runs the graders in build/bin. Advances `progress` by one a case.
std::vector<ZooRow> zooRows(const std::filesystem::path& build, const std::vector<ZooCase>& cases,
                            Progress& progress);

// Where a curve teaches more than a point: what autograder/NN-name/curves.cpp measures of the
// solution (core/curves.h).
struct ZooCurve {
    std::string assignment, svg;
    std::string json;  // of N.grade --curves, with its facts
    std::string title, says;
    std::vector<std::string> facts;  // in words
    bool holds = false;              // all of them
};

// Assignments that have curves and a solution.
std::vector<std::string> assignmentsWithCurves();
std::vector<ZooCurve> zooCurves(const std::filesystem::path& build,
                                const std::vector<std::string>& assignments, Progress& progress);

std::string zooJson(const std::vector<ZooRow>& rows, const std::vector<ZooCurve>& curves);
std::string zooHtml(const std::vector<ZooRow>& rows, const std::vector<ZooCurve>& curves);

}  // namespace penumbra
