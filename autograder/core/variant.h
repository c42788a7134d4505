// Which program and which folders make a variant: handout, solution, mistake or submission.
//
//   const Place place{.root = PENUMBRA_ROOT, .build = build, .assignment = "05-shadow-map"};
//   Variant v = submissionVariant(place, "incoming/ada", scratch);
//   runRender(v.program, …);
#pragma once

#include <set>

#include "core/runner.h"

namespace penumbra {

// Where an assignment lives.
struct Place {
    std::filesystem::path root;   // of the source tree
    std::filesystem::path build;  // its build tree; programs stand in build/bin
    std::string assignment;       // 05-shadow-map

    std::filesystem::path handout() const { return root / "assignments" / assignment; }
    std::filesystem::path grader() const { return root / "autograder" / assignment; }
};

struct Variant {
    std::string name;  // as the report calls it
    VariantProgram program;
    std::vector<std::string> warnings = {};
    // The student's files: the handout edited in place, or the staged submission. Empty for
    // variants of ours, which are never "not started".
    std::filesystem::path studentFolder = {};
};

// What a student may write: the handout's files at its top, README.md excepted.
std::set<std::string> studentFiles(const Place& place);

Variant handoutVariant(const Place& place);
Variant solutionVariant(const Place& place);
Variant mistakeVariant(const Place& place, const std::string& mistake);

// Stages the student's files (plain files of known names, nothing else) and builds them if there is
// C++. Code that does not compile is a reason, not an Error. Throws Error for a folder that holds
// nothing.
Variant submissionVariant(const Place& place, const std::filesystem::path& folder);

// The program of the staged C++ files, built against the framework's library as it stands in
// place.build. Returns a VariantProgram whose `broken` says what the compiler said.
VariantProgram buildSubmission(const Place& place, const std::filesystem::path& staged);

// "light_frustum.cpp:12: 'x' was not declared": the first complaint in a compiler's or linker's
// output.
std::string firstComplaint(const std::string& output);

}  // namespace penumbra
