// What one grading run leaves behind: comparisons, verdicts, points. Written by checks.h and
// grade.h, read by the reports.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra {

enum class Verdict { pass, fail, notStarted, graderError };

// One measured thing beside its truth. Pictures are PNG bytes, empty where there is none.
struct Comparison {
    std::string subject;         // "visibility", "penumbra width at x = 2"
    std::string measured = "";   // "mean |difference| 0.0123"
    std::string tolerance = "";  // "at most 0.004"
    std::string cause = "";      // why that tolerance and no other
    bool passed = false;
    std::vector<unsigned char> mine = {}, truth = {}, difference = {};
};

struct CheckRecord {
    std::string suite;     // Task3DepthBias
    std::string name;      // NoAcneOnAPlaneUpTo89Degrees
    std::string sentence;  // "Task 3 · depth bias: no acne on a plane up to 89 degrees"
    Verdict verdict = Verdict::pass;
    double points = 0;  // of `maximum`
    double maximum = 0;
    double seconds = 0;
    std::vector<std::string> reasons;  // why not passed
    std::vector<std::string> frames;   // requests that it looked at
    std::vector<Comparison> comparisons;
    std::string section;  // anchor in the handout's README
};

struct TaskRecord {
    std::string suite;
    std::string title;
    std::string section;
    std::vector<std::string> files;
    std::vector<CheckRecord> checks;
};

struct GradeRecord {
    std::string assignment;  // 05-shadow-map
    std::string title;
    std::string variant;  // handout, solution, "wrong: unbiased", submission's folder
    std::vector<TaskRecord> tasks;
    std::vector<std::string> warnings;
    std::string looksLike;  // the mistake's name, "" = none
    double seconds = 0;
    int runs = 0;                   // children started
    std::size_t peakBytes = 0;      // of the largest child
    std::filesystem::path handout;  // its folder, for links
};

std::string toString(Verdict verdict);

// Points got and points that could be got: a grader error neither gives nor takes.
double pointsOf(const GradeRecord& grade);
double maximumOf(const GradeRecord& grade);

// 0 all points, 1 some lost, 3 the grader was in trouble.
int exitCode(const GradeRecord& grade);

// "Task3DepthBias", "NoAcneUpTo89Degrees" -> "Task 3 · depth bias: no acne up to 89 degrees".
std::string sentence(const std::string& suite, const std::string& name);

}  // namespace penumbra
